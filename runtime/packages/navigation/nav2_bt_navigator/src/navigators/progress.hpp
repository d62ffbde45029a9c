// Shared by both navigators: parameters, trees, transforms and feedback.
#pragma once

#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_core/behavior_tree_navigator.hpp"
#include "nav2_util/robot_utils.hpp"
#include "nav_msgs/msg/path.hpp"

namespace nav2_bt_navigator {

template <typename T>
T parameter(rclcpp_lifecycle::LifecycleNode& node, const std::string& name, T otherwise) {
  if (!node.has_parameter(name)) node.declare_parameter(name, rclcpp::ParameterValue(otherwise));
  return node.get_parameter(name).get_value<T>();
}

/// The parameter's value, else a tree of this package.
std::string tree_file(rclcpp_lifecycle::LifecycleNode& node, const std::string& parameter_name,
                      const std::string& default_file);

/// Along the path, from the pose that is closest to the robot [m].
double length_ahead(const nav_msgs::msg::Path& path, const geometry_msgs::msg::PoseStamped& robot);

/// The same of the blackboard's path; 0 when it has none.
double length_of_entry(const BT::Blackboard& blackboard, const std::string& path_id,
                       const geometry_msgs::msg::PoseStamped& robot);

inline bool find_robot(const nav2_core::FeedbackUtils& utils,
                       geometry_msgs::msg::PoseStamped& pose) {
  return nav2_util::getCurrentPose(pose, *utils.tf, utils.global_frame, utils.robot_frame,
                                   utils.transform_tolerance);
}

/// False, with a message, when the transform is not known.
bool to_global_frame(const nav2_core::FeedbackUtils& utils, const rclcpp::Logger& logger,
                     geometry_msgs::msg::PoseStamped& goal);

template <typename ServerT>
void set_groot(rclcpp_lifecycle::LifecycleNode& node, const std::string& name, int port,
               ServerT& server) {
  const bool is_enabled = parameter(node, name + ".enable_groot_monitoring", false);
  const int used_port = parameter(node, name + ".groot_server_port", port);
  server.setGrootMonitoring(is_enabled, static_cast<unsigned>(used_port));
}

/// Whether a goal that waits may take the place of the one that runs: both want one tree.
template <typename ServerT>
bool wants_same_tree(const ServerT& server, const std::string& tree) {
  const std::string current = server.getCurrentBTFilename();
  return tree == current || (tree.empty() && current == server.getDefaultBTFilename());
}

inline constexpr const char* kOtherTree =
    "Preemption request was rejected since the requested BT XML file is not the same as the one "
    "that the current goal is executing. Preemption with a new BT is invalid since it would "
    "require cancellation of the previous goal instead of true preemption.\nCancel the current "
    "goal and send a new action request if you want to use a different BT XML file. For now, "
    "continuing to track the last goal until completion.";

/// How far it is, how long that takes at the robot's speed, and what happened.
template <typename FeedbackT>
void fill_feedback(FeedbackT& feedback, const BT::Blackboard& blackboard,
                   const std::string& path_id, const geometry_msgs::msg::PoseStamped& robot,
                   nav2_util::OdomSmoother& odometry) {
  if (const double length = length_of_entry(blackboard, path_id, robot); length > 0.0) {
    const auto twist = odometry.getTwist();
    const double speed = std::hypot(twist.linear.x, twist.linear.y);
    feedback.distance_remaining = static_cast<float>(length);
    if (speed > 0.01 && length > 0.1) {
      feedback.estimated_time_remaining = rclcpp::Duration::from_seconds(length / speed);
    }
  }
  int recoveries = 0;
  blackboard.get("number_recoveries", recoveries);
  feedback.number_of_recoveries = static_cast<int16_t>(recoveries);
  feedback.current_pose = robot;
}

}  // namespace nav2_bt_navigator
