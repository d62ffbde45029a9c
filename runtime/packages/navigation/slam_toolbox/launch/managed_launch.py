"""Starts a node of slam_toolbox, configures it and activates it."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, EmitEvent, LogInfo, RegisterEventHandler
from launch.conditions import IfCondition
from launch.events import matches_action
from launch.substitutions import AndSubstitution, LaunchConfiguration, NotSubstitution
from launch_ros.actions import LifecycleNode
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import Transition


def generate_launch_description():
    use_lifecycle_manager = LaunchConfiguration('use_lifecycle_manager')
    node = LifecycleNode(
        package='slam_toolbox', executable=LaunchConfiguration('slam_toolbox_executable'), name='slam_toolbox',
        namespace='', output='screen',
        parameters=[LaunchConfiguration('slam_params_file'),
                    {'use_lifecycle_manager': use_lifecycle_manager,
                     'use_sim_time': LaunchConfiguration('use_sim_time')}])
    starts = IfCondition(AndSubstitution(LaunchConfiguration('autostart'), NotSubstitution(use_lifecycle_manager)))

    def change(transition, condition=None):
        return EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(node), transition_id=transition),
                         condition=condition)

    activate = RegisterEventHandler(
        OnStateTransition(target_lifecycle_node=node, start_state='configuring', goal_state='inactive',
                          entities=[LogInfo(msg='[LifecycleLaunch] Slamtoolbox node is activating.'),
                                    change(Transition.TRANSITION_ACTIVATE)]),
        condition=starts)
    return LaunchDescription([
        DeclareLaunchArgument('autostart', default_value='true',
                              description='Whether the node is configured and activated'),
        DeclareLaunchArgument('use_lifecycle_manager', default_value='false',
                              description='Whether a lifecycle manager does so, and has a bond with the node'),
        DeclareLaunchArgument('use_sim_time', default_value='true', description='Whether time is that of /clock'),
        DeclareLaunchArgument('slam_toolbox_executable', description='The program'),
        DeclareLaunchArgument('slam_params_file', description='File with the parameters'),
        node, change(Transition.TRANSITION_CONFIGURE, starts), activate,
    ])
