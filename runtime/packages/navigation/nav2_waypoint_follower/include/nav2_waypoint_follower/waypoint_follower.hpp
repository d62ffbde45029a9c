// Visits waypoints in their order: it sends the goals of a tour to navigate_to_pose, one after the
// other, and runs a task plugin at each.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "geographic_msgs/msg/geo_pose.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_core/waypoint_task_executor.hpp"
#include "nav2_msgs/action/follow_gps_waypoints.hpp"
#include "nav2_msgs/action/follow_waypoints.hpp"
#include "nav2_msgs/action/navigate_to_pose.hpp"
#include "nav2_msgs/msg/missed_waypoint.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/service_client.hpp"
#include "nav2_util/simple_action_server.hpp"
#include "nav2_util/string_utils.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "robot_localization/srv/from_ll.hpp"

namespace nav2_waypoint_follower {

enum class ActionStatus { UNKNOWN = 0, PROCESSING = 1, FAILED = 2, SUCCEEDED = 3 };

struct GoalStatus {
  ActionStatus status = ActionStatus::UNKNOWN;
  int error_code = 0;  // of navigate_to_pose
};

class WaypointFollower : public nav2_util::LifecycleNode {
 public:
  using ActionT = nav2_msgs::action::FollowWaypoints;
  using ClientT = nav2_msgs::action::NavigateToPose;
  using ActionServer = nav2_util::SimpleActionServer<ActionT>;
  using ActionClient = rclcpp_action::Client<ClientT>;
  using ActionTGPS = nav2_msgs::action::FollowGPSWaypoints;
  using ActionServerGPS = nav2_util::SimpleActionServer<ActionTGPS>;

  explicit WaypointFollower(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~WaypointFollower();

 protected:
  using Poses = std::vector<geometry_msgs::msg::PoseStamped>;
  using Missed = std::vector<nav2_msgs::msg::MissedWaypoint>;

  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  /// The work of both actions.
  void followWaypointsCallback();
  void followGPSWaypointsCallback();
  template <typename ServerT, typename FollowT>
  void followWaypointsHandler(ServerT& server);

  /// Empty when a place cannot be converted and stop_on_failure is set.
  Poses convertGPSPosesToMapPoses(const std::vector<geographic_msgs::msg::GeoPose>& gps_poses);
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

 private:
  /// The waypoints of one goal, and how far it is.
  struct Tour {
    Poses poses;
    uint32_t index = 0;
    uint32_t loop = 0;
    uint32_t loops = 0;  // after the first
    bool is_at_new_waypoint = true;
  };
  enum class Step { kWait, kNext, kStop };

  Poses posesOf(const ActionT::Goal& goal);
  Poses posesOf(const ActionTGPS::Goal& goal);
  bool isUsable(const Tour& tour);
  void navigateTo(const geometry_msgs::msg::PoseStamped& pose);
  void cancelNavigation();
  /// Handles the end of navigation to a waypoint, and its task.
  Step step(const Tour& tour, Missed& missed);
  Step stepAfterFailure(const Tour& tour, Missed& missed);
  Step stepAfterArrival(const Tour& tour, Missed& missed);
  /// False after the last waypoint of the last loop.
  bool advance(Tour& tour);
  bool loadTask();

  std::string global_frame_id_{"map"};
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
  std::unique_ptr<ActionServer> xyz_action_server_;
  std::unique_ptr<ActionServerGPS> gps_action_server_;
  ActionClient::SharedPtr nav_to_pose_client_;
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  rclcpp::executors::SingleThreadedExecutor callback_group_executor_;
  std::unique_ptr<nav2_util::ServiceClient<robot_localization::srv::FromLL,
                                           std::shared_ptr<nav2_util::LifecycleNode>>>
      from_ll_to_map_client_;

  std::atomic<bool> stop_on_failure_{true};
  std::atomic<int> loop_rate_{20};  // Hz
  std::mutex tour_mutex_;           // both actions have a thread; one of them navigates
  GoalStatus current_goal_status_;
  uint64_t last_goal_ = 0;  // answers to earlier ones do not count

  pluginlib::ClassLoader<nav2_core::WaypointTaskExecutor> waypoint_task_executor_loader_;
  pluginlib::UniquePtr<nav2_core::WaypointTaskExecutor> waypoint_task_executor_;
  std::string waypoint_task_executor_id_;
  std::string waypoint_task_executor_type_;
};

}  // namespace nav2_waypoint_follower
