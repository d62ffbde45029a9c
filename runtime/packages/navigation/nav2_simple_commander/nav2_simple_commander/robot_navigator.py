"""A node that sends a robot somewhere, and asks how far it is."""
from __future__ import annotations

import time
from enum import Enum
from typing import Any

import rclpy
from action_msgs.msg import GoalStatus
from builtin_interfaces.msg import Duration
from geometry_msgs.msg import Point, PoseStamped, PoseWithCovarianceStamped
from lifecycle_msgs.srv import GetState
from nav2_msgs.action import (
    AssistedTeleop, BackUp, ComputePathThroughPoses, ComputePathToPose, DockRobot, DriveOnHeading, FollowGPSWaypoints,
    FollowPath, FollowWaypoints, NavigateThroughPoses, NavigateToPose, SmoothPath, Spin, UndockRobot,
)
from nav2_msgs.srv import (
    ClearCostmapAroundPose, ClearCostmapAroundRobot, ClearCostmapExceptRegion, ClearEntireCostmap, GetCostmap, LoadMap,
    ManageLifecycleNodes,
)
from rclpy.action import ActionClient
from rclpy.client import Client
from rclpy.duration import Duration as rclpyDuration
from rclpy.node import Node
from rclpy.qos import QoSDurabilityPolicy, QoSHistoryPolicy, QoSProfile, QoSReliabilityPolicy


class TaskResult(Enum):
    """How a task ended."""

    UNKNOWN = 0
    SUCCEEDED = 1
    CANCELED = 2
    FAILED = 3


RESULTS = {
    GoalStatus.STATUS_SUCCEEDED: TaskResult.SUCCEEDED,
    GoalStatus.STATUS_ABORTED: TaskResult.FAILED,
    GoalStatus.STATUS_CANCELED: TaskResult.CANCELED,
}
AMCL_POSE_QOS = QoSProfile(
    durability=QoSDurabilityPolicy.TRANSIENT_LOCAL, reliability=QoSReliabilityPolicy.RELIABLE,
    history=QoSHistoryPolicy.KEEP_LAST, depth=1)


class BasicNavigator(Node):
    """
    Runs one task at a time. Calls that begin a task return whether it was accepted.

    The node is spun by its calls: a task advances in `isTaskComplete`.
    """

    def __init__(self, node_name: str = 'basic_navigator', namespace: str = '') -> None:
        super().__init__(node_name=node_name, namespace=namespace)
        self.initial_pose = PoseStamped()
        self.initial_pose.header.frame_id = 'map'
        self.goal_handle: Any = None
        self.result_future: Any = None
        self.feedback: Any = None
        self.status: int | None = None
        self.initial_pose_received = False
        self._create_action_clients()
        self._create_service_clients()
        self.localization_pose_sub = self.create_subscription(
            PoseWithCovarianceStamped, 'amcl_pose', self._amclPoseCallback, AMCL_POSE_QOS)
        self.initial_pose_pub = self.create_publisher(PoseWithCovarianceStamped, 'initialpose', 10)

    def _create_action_clients(self) -> None:
        self._action_clients: list[ActionClient] = []

        def client(action: Any, name: str) -> ActionClient:
            self._action_clients.append(ActionClient(self, action, name))
            return self._action_clients[-1]

        self.nav_through_poses_client = client(NavigateThroughPoses, 'navigate_through_poses')
        self.nav_to_pose_client = client(NavigateToPose, 'navigate_to_pose')
        self.follow_waypoints_client = client(FollowWaypoints, 'follow_waypoints')
        self.follow_gps_waypoints_client = client(FollowGPSWaypoints, 'follow_gps_waypoints')
        self.follow_path_client = client(FollowPath, 'follow_path')
        self.compute_path_to_pose_client = client(ComputePathToPose, 'compute_path_to_pose')
        self.compute_path_through_poses_client = client(ComputePathThroughPoses, 'compute_path_through_poses')
        self.smoother_client = client(SmoothPath, 'smooth_path')
        self.spin_client = client(Spin, 'spin')
        self.backup_client = client(BackUp, 'backup')
        self.drive_on_heading_client = client(DriveOnHeading, 'drive_on_heading')
        self.assisted_teleop_client = client(AssistedTeleop, 'assisted_teleop')
        self.docking_client = client(DockRobot, 'dock_robot')
        self.undocking_client = client(UndockRobot, 'undock_robot')

    def _create_service_clients(self) -> None:
        self.change_maps_srv = self.create_client(LoadMap, 'map_server/load_map')
        self.clear_costmap_global_srv = self.create_client(
            ClearEntireCostmap, 'global_costmap/clear_entirely_global_costmap')
        self.clear_costmap_local_srv = self.create_client(
            ClearEntireCostmap, 'local_costmap/clear_entirely_local_costmap')
        self.clear_costmap_except_region_srv = self.create_client(
            ClearCostmapExceptRegion, 'local_costmap/clear_costmap_except_region')
        self.clear_costmap_around_robot_srv = self.create_client(
            ClearCostmapAroundRobot, 'local_costmap/clear_costmap_around_robot')
        self.clear_costmap_around_pose_srv = self.create_client(
            ClearCostmapAroundPose, 'local_costmap/clear_costmap_around_pose')
        self.get_costmap_global_srv = self.create_client(GetCostmap, 'global_costmap/get_costmap')
        self.get_costmap_local_srv = self.create_client(GetCostmap, 'local_costmap/get_costmap')

    def destroyNode(self) -> None:
        """Destroy the node and its clients."""
        self.destroy_node()

    def destroy_node(self) -> None:
        """Destroy the node and its clients."""
        for client in self._action_clients:
            client.destroy()
        super().destroy_node()

    # Tasks

    def goThroughPoses(self, poses: list[Any], behavior_tree: str = '') -> bool:
        """Drive to the last pose by way of the others."""
        self._wait_for_server(self.nav_through_poses_client, 'NavigateThroughPoses')
        self.info(f'Navigating with {len(poses)} goals....')
        goal = NavigateThroughPoses.Goal(poses=poses, behavior_tree=behavior_tree)
        return self._begin(self.nav_through_poses_client, goal, f'Goal with {len(poses)} poses was rejected!')

    def goToPose(self, pose: Any, behavior_tree: str = '') -> bool:
        """Drive to a pose."""
        self._wait_for_server(self.nav_to_pose_client, 'NavigateToPose')
        place = f'{pose.pose.position.x} {pose.pose.position.y}'
        self.info(f'Navigating to goal: {place}...')
        goal = NavigateToPose.Goal(pose=pose, behavior_tree=behavior_tree)
        return self._begin(self.nav_to_pose_client, goal, f'Goal to {place} was rejected!')

    def followWaypoints(self, poses: list[Any]) -> bool:
        """Visit poses, and do at each what the waypoint follower is set up for."""
        self._wait_for_server(self.follow_waypoints_client, 'FollowWaypoints')
        self.info(f'Following {len(poses)} goals....')
        return self._begin(
            self.follow_waypoints_client, FollowWaypoints.Goal(poses=poses),
            f'Following {len(poses)} waypoints request was rejected!')

    def followGpsWaypoints(self, gps_poses: list[Any]) -> bool:
        """Visit places of geographic_msgs/GeoPose."""
        self._wait_for_server(self.follow_gps_waypoints_client, 'FollowWaypoints')
        self.info(f'Following {len(gps_poses)} gps goals....')
        return self._begin(
            self.follow_gps_waypoints_client, FollowGPSWaypoints.Goal(gps_poses=gps_poses),
            f'Following {len(gps_poses)} gps waypoints request was rejected!')

    def spin(self, spin_dist: float = 1.57, time_allowance: int = 10) -> bool:
        """Turn on the spot by an angle [rad], within a time [s]."""
        self._wait_for_server(self.spin_client, 'Spin')
        goal = Spin.Goal(target_yaw=spin_dist, time_allowance=Duration(sec=time_allowance))
        self.info(f'Spinning to angle {goal.target_yaw}....')
        return self._begin(self.spin_client, goal, 'Spin request was rejected!')

    def backup(self, backup_dist: float = 0.15, backup_speed: float = 0.025, time_allowance: int = 10) -> bool:
        """Drive backwards by a distance [m] at a speed [m/s], within a time [s]."""
        self._wait_for_server(self.backup_client, 'Backup')
        goal = BackUp.Goal(
            target=Point(x=float(backup_dist)), speed=backup_speed, time_allowance=Duration(sec=time_allowance))
        self.info(f'Backing up {goal.target.x} m at {goal.speed} m/s....')
        return self._begin(self.backup_client, goal, 'Backup request was rejected!')

    def driveOnHeading(self, dist: float = 0.15, speed: float = 0.025, time_allowance: int = 10) -> bool:
        """Drive ahead by a distance [m] at a speed [m/s], within a time [s]."""
        self._wait_for_server(self.drive_on_heading_client, 'DriveOnHeading')
        goal = DriveOnHeading.Goal(
            target=Point(x=float(dist)), speed=speed, time_allowance=Duration(sec=time_allowance))
        self.info(f'Drive {goal.target.x} m on heading at {goal.speed} m/s....')
        return self._begin(self.drive_on_heading_client, goal, 'Drive On Heading request was rejected!')

    def assistedTeleop(self, time_allowance: int = 30) -> bool:
        """Let a person steer, for a time [s]."""
        self._wait_for_server(self.assisted_teleop_client, 'assisted_teleop')
        self.info("Running 'assisted_teleop'....")
        goal = AssistedTeleop.Goal(time_allowance=Duration(sec=time_allowance))
        return self._begin(self.assisted_teleop_client, goal, 'Assisted Teleop request was rejected!')

    def followPath(self, path: Any, controller_id: str = '', goal_checker_id: str = '') -> bool:
        """Drive along a path."""
        self._wait_for_server(self.follow_path_client, 'FollowPath')
        self.info('Executing path...')
        goal = FollowPath.Goal(path=path, controller_id=controller_id, goal_checker_id=goal_checker_id)
        return self._begin(self.follow_path_client, goal, 'Follow path was rejected!')

    def dockRobotByPose(self, dock_pose: Any, dock_type: str, nav_to_dock: bool = True) -> bool:
        """Drive onto a dock at a pose, with or without a drive to the place before it."""
        goal = DockRobot.Goal(
            use_dock_id=False, dock_pose=dock_pose, dock_type=dock_type, navigate_to_staging_pose=nav_to_dock)
        return self._dock(goal, f'Docking at pose: {dock_pose}...')

    def dockRobotByID(self, dock_id: str, nav_to_dock: bool = True) -> bool:
        """Drive onto a dock that the server knows."""
        goal = DockRobot.Goal(use_dock_id=True, dock_id=dock_id, navigate_to_staging_pose=nav_to_dock)
        return self._dock(goal, f'Docking at dock ID: {dock_id}...')

    def _dock(self, goal: Any, message: str) -> bool:
        self._wait_for_dock_server(self.docking_client, 'DockRobot')
        self.info(message)
        return self._begin(self.docking_client, goal, 'Docking request was rejected!', self.info)

    def undockRobot(self, dock_type: str = '') -> bool:
        """Leave a dock."""
        self._wait_for_dock_server(self.undocking_client, 'UndockRobot')
        self.info(f'Undocking from dock of type: {dock_type}...')
        goal = UndockRobot.Goal(dock_type=dock_type)
        return self._begin(self.undocking_client, goal, 'Undocking request was rejected!', self.info)

    def cancelTask(self) -> None:
        """Ask the server of the task to end it."""
        self.info('Canceling current task.')
        if self.result_future:
            rclpy.spin_until_future_complete(self, self.goal_handle.cancel_goal_async())

    def isTaskComplete(self) -> bool:
        """Wait up to 0.1 s for the end of the task; without a task it is complete."""
        if not self.result_future:
            return True
        rclpy.spin_until_future_complete(self, self.result_future, timeout_sec=0.10)
        result = self.result_future.result()
        if not result:
            return False
        self.status = result.status
        if self.status == GoalStatus.STATUS_SUCCEEDED:
            self.debug('Task succeeded!')
        else:
            self.debug(f'Task with failed with status code: {self.status}')
        return True

    def getFeedback(self) -> Any:
        """Get the latest feedback of a task, or None."""
        return self.feedback

    def getResult(self) -> TaskResult:
        """Get how the last task ended that `isTaskComplete` saw, or a plan."""
        return RESULTS.get(self.status, TaskResult.UNKNOWN)

    # Plans

    def getPath(self, start: Any, goal: Any, planner_id: str = '', use_start: bool = False) -> Any:
        """Get a path to a pose, or None. Without `use_start` it begins at the robot."""
        return self._path_of(self._getPathImpl(start, goal, planner_id, use_start))

    def _getPathImpl(self, start: Any, goal: Any, planner_id: str = '', use_start: bool = False) -> Any:
        self._wait_for_server(self.compute_path_to_pose_client, 'ComputePathToPose')
        self.info('Getting path...')
        return self._result(
            self.compute_path_to_pose_client,
            ComputePathToPose.Goal(start=start, goal=goal, planner_id=planner_id, use_start=use_start),
            'Get path was rejected!')

    def getPathThroughPoses(
        self, start: Any, goals: list[Any], planner_id: str = '', use_start: bool = False
    ) -> Any:
        """Get a path to the last pose by way of the others, or None."""
        return self._path_of(self._getPathThroughPosesImpl(start, goals, planner_id, use_start))

    def _getPathThroughPosesImpl(
        self, start: Any, goals: list[Any], planner_id: str = '', use_start: bool = False
    ) -> Any:
        self._wait_for_server(self.compute_path_through_poses_client, 'ComputePathThroughPoses')
        self.info('Getting path...')
        return self._result(
            self.compute_path_through_poses_client,
            ComputePathThroughPoses.Goal(start=start, goals=goals, planner_id=planner_id, use_start=use_start),
            'Get path was rejected!')

    def smoothPath(
        self, path: Any, smoother_id: str = '', max_duration: float = 2.0, check_for_collision: bool = False
    ) -> Any:
        """Get a smoother path, made within a time [s], or None."""
        return self._path_of(self._smoothPathImpl(path, smoother_id, max_duration, check_for_collision))

    def _smoothPathImpl(
        self, path: Any, smoother_id: str = '', max_duration: float = 2.0, check_for_collision: bool = False
    ) -> Any:
        self._wait_for_server(self.smoother_client, 'SmoothPath')
        self.info('Smoothing path...')
        goal = SmoothPath.Goal(
            path=path, smoother_id=smoother_id, max_smoothing_duration=rclpyDuration(seconds=max_duration).to_msg(),
            check_for_collisions=check_for_collision)
        return self._result(self.smoother_client, goal, 'Smooth path was rejected!')

    # Maps

    def changeMap(self, map_filepath: str) -> None:
        """Make the map server read another file."""
        response = self._call(
            self.change_maps_srv, LoadMap.Request(map_url=map_filepath), 'change map service not available, waiting...')
        if response.result != LoadMap.Response.RESULT_SUCCESS:
            self.error('Change map request failed!')
        else:
            self.info('Change map request was successful!')

    def clearAllCostmaps(self) -> None:
        """Forget all obstacles."""
        self.clearLocalCostmap()
        self.clearGlobalCostmap()

    def clearLocalCostmap(self) -> None:
        """Forget the obstacles around the robot."""
        self._call(
            self.clear_costmap_local_srv, ClearEntireCostmap.Request(),
            'Clear local costmaps service not available, waiting...')

    def clearGlobalCostmap(self) -> None:
        """Forget the obstacles that plans avoid."""
        self._call(
            self.clear_costmap_global_srv, ClearEntireCostmap.Request(),
            'Clear global costmaps service not available, waiting...')

    def clearCostmapExceptRegion(self, reset_distance: float) -> None:
        """Forget the obstacles that are further from the robot [m]."""
        self._call(
            self.clear_costmap_except_region_srv, ClearCostmapExceptRegion.Request(reset_distance=reset_distance),
            'ClearCostmapExceptRegion service not available, waiting...')

    def clearCostmapAroundRobot(self, reset_distance: float) -> None:
        """Forget the obstacles that are nearer to the robot [m]."""
        self._call(
            self.clear_costmap_around_robot_srv, ClearCostmapAroundRobot.Request(reset_distance=reset_distance),
            'ClearCostmapAroundRobot service not available, waiting...')

    def clearCostmapAroundPose(self, pose: Any, reset_distance: float) -> None:
        """Forget the obstacles that are nearer to a pose [m]."""
        self._call(
            self.clear_costmap_around_pose_srv,
            ClearCostmapAroundPose.Request(pose=pose, reset_distance=reset_distance),
            'ClearCostmapAroundPose service not available, waiting...')

    def getGlobalCostmap(self) -> Any:
        """Get the costs that plans avoid (nav2_msgs/Costmap)."""
        return self._call(
            self.get_costmap_global_srv, GetCostmap.Request(), 'Get global costmaps service not available, waiting...'
        ).map

    def getLocalCostmap(self) -> Any:
        """Get the costs around the robot (nav2_msgs/Costmap)."""
        return self._call(
            self.get_costmap_local_srv, GetCostmap.Request(), 'Get local costmaps service not available, waiting...'
        ).map

    # The servers

    def setInitialPose(self, initial_pose: Any) -> None:
        """Say where the robot is."""
        self.initial_pose_received = False
        self.initial_pose = initial_pose
        self._setInitialPose()

    def waitUntilNav2Active(self, navigator: str = 'bt_navigator', localizer: str = 'amcl') -> None:
        """Wait for both servers; repeat the initial pose until amcl has one."""
        if localizer != 'robot_localization':
            self._waitForNodeToActivate(localizer)
        if localizer == 'amcl':
            self._waitForInitialPose()
        self._waitForNodeToActivate(navigator)
        self.info('Nav2 is ready for use!')

    def lifecycleStartup(self) -> None:
        """Ask all lifecycle managers to start their servers. Their ends are not waited for."""
        self.info('Starting up lifecycle nodes based on lifecycle_manager.')
        for name in self._managers():
            self.info(f'Starting up {name}')
            self._manage(name, ManageLifecycleNodes.Request.STARTUP, timeout_sec=0.10)
        self.info('Nav2 is ready for use!')

    def lifecycleShutdown(self) -> None:
        """Make all lifecycle managers shut their servers down."""
        self.info('Shutting down lifecycle nodes based on lifecycle_manager.')
        for name in self._managers():
            self.info(f'Shutting down {name}')
            self._manage(name, ManageLifecycleNodes.Request.SHUTDOWN)

    def _managers(self) -> list[str]:
        """Get the names of services that manage nodes."""
        services = self.get_service_names_and_types()
        return [name for name, types in services if types[0] == 'nav2_msgs/srv/ManageLifecycleNodes']

    def _manage(self, name: str, command: int, timeout_sec: float | None = None) -> None:
        client = self.create_client(ManageLifecycleNodes, name)
        request = ManageLifecycleNodes.Request(command=command)
        self._call(client, request, f'{name} service not available, waiting...', timeout_sec)

    def _waitForNodeToActivate(self, node_name: str) -> None:
        self.debug(f'Waiting for {node_name} to become active..')
        service = f'{node_name}/get_state'
        client = self.create_client(GetState, service)
        state = 'unknown'
        while state != 'active':
            self.debug(f'Getting {node_name} state...')
            response = self._call(client, GetState.Request(), f'{service} service not available, waiting...')
            if response is not None:
                state = response.current_state.label
                self.debug(f'Result of get_state: {state}')
            time.sleep(2)

    def _waitForInitialPose(self) -> None:
        while not self.initial_pose_received:
            self.info('Setting initial pose')
            self._setInitialPose()
            self.info('Waiting for amcl_pose to be received')
            rclpy.spin_once(self, timeout_sec=1.0)

    def _setInitialPose(self) -> None:
        message = PoseWithCovarianceStamped(header=self.initial_pose.header)
        message.pose.pose = self.initial_pose.pose
        self.info('Publishing Initial Pose')
        self.initial_pose_pub.publish(message)

    def _amclPoseCallback(self, msg: Any) -> None:
        self.debug('Received amcl pose')
        self.initial_pose_received = True

    def _feedbackCallback(self, msg: Any) -> None:
        self.debug('Received action feedback message')
        self.feedback = msg.feedback

    # Goals and requests

    def _wait_for_server(self, client: ActionClient, name: str) -> None:
        self.debug(f"Waiting for '{name}' action server")
        while not client.wait_for_server(timeout_sec=1.0):
            self.info(f"'{name}' action server not available, waiting...")

    def _wait_for_dock_server(self, client: ActionClient, name: str) -> None:
        self.info(f"Waiting for '{name}' action server")
        while not client.wait_for_server(timeout_sec=1.0):
            self.info(f'"{name}" action server not available, waiting...')

    def _begin(self, client: ActionClient, goal: Any, refusal: str, say: Any = None, hears: bool = True) -> bool:
        """Send a goal; False, and the text of a refusal, when it is not accepted."""
        sent = client.send_goal_async(goal, self._feedbackCallback if hears else None)
        rclpy.spin_until_future_complete(self, sent)
        self.goal_handle = sent.result()
        if not self.goal_handle.accepted:
            (say or self.error)(refusal)
            return False
        self.result_future = self.goal_handle.get_result_async()
        return True

    def _result(self, client: ActionClient, goal: Any, refusal: str) -> Any:
        """Wait for the result of a goal; None when it is not accepted."""
        if not self._begin(client, goal, refusal, hears=False):
            return None
        rclpy.spin_until_future_complete(self, self.result_future)
        result = self.result_future.result()
        self.status = result.status
        return result.result

    def _path_of(self, result: Any) -> Any:
        if self.status != GoalStatus.STATUS_SUCCEEDED:
            self.warn(f'Getting path failed with status code: {self.status}')
            return None
        return result.path if result else None

    def _call(self, client: Client, request: Any, absent: str, timeout_sec: float | None = None) -> Any:
        """Wait for a service, with a text each second, and for its response; None when there is none in time."""
        while not client.wait_for_service(timeout_sec=1.0):
            self.info(absent)
        future = client.call_async(request)
        rclpy.spin_until_future_complete(self, future, timeout_sec=timeout_sec)
        return future.result()

    def info(self, msg: str) -> None:
        """Log a message."""
        self.get_logger().info(msg)

    def warn(self, msg: str) -> None:
        """Log a warning."""
        self.get_logger().warn(msg)

    def error(self, msg: str) -> None:
        """Log an error."""
        self.get_logger().error(msg)

    def debug(self, msg: str) -> None:
        """Log what helps to find mistakes."""
        self.get_logger().debug(msg)
