from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    use_sim_time = LaunchConfiguration('use_sim_time', default=True)
    robot_description_content = Command([
        PathJoinSubstitution([FindExecutable(name='xacro')]), ' ',
        PathJoinSubstitution([FindPackageShare('sim_arm_position'), 'urdf', 'arm.urdf.xacro']),
    ])
    robot_description = {'robot_description': robot_description_content}

    node_robot_state_publisher = Node(
        package='robot_state_publisher', executable='robot_state_publisher', output='screen',
        parameters=[robot_description, {'use_sim_time': use_sim_time}])
    gz_spawn_entity = Node(
        package='ros_gz_sim', executable='create', output='screen',
        arguments=['-topic', 'robot_description', '-name', 'arm', '-allow_renaming', 'true'])
    bridge = Node(
        package='ros_gz_bridge', executable='parameter_bridge', output='screen',
        arguments=['/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock',
                   '/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model']
        + [f'/{name}_cmd@std_msgs/msg/Float64]gz.msgs.Double' for name in ('base', 'upper', 'fore')])
    reacher = Node(
        package='sim_arm_position', executable='reacher', output='screen',
        parameters=[{'use_sim_time': use_sim_time}])

    return LaunchDescription([
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource([
                PathJoinSubstitution([FindPackageShare('ros_gz_sim'), 'launch', 'gz_sim.launch.py'])]),
            launch_arguments=[('gz_args', [
                ' -r -v 1 ', PathJoinSubstitution([FindPackageShare('sim_arm_position'), 'worlds', 'cell.sdf'])])]),
        RegisterEventHandler(event_handler=OnProcessExit(target_action=gz_spawn_entity, on_exit=[reacher])),
        bridge,
        node_robot_state_publisher,
        gz_spawn_entity,
        DeclareLaunchArgument('use_sim_time', default_value=use_sim_time, description='If true, use simulated clock'),
    ])
