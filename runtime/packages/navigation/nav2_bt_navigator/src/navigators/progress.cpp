// See progress.hpp.
#include "navigators/progress.hpp"

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "nav2_util/geometry_utils.hpp"

namespace nav2_bt_navigator {

using geometry_msgs::msg::PoseStamped;

std::string tree_file(rclcpp_lifecycle::LifecycleNode& node, const std::string& parameter_name,
                      const std::string& default_file) {
  const std::string folder = ament_index_cpp::get_package_share_directory("nav2_bt_navigator");
  return parameter(node, parameter_name, folder + "/behavior_trees/" + default_file);
}

double length_ahead(const nav_msgs::msg::Path& path, const PoseStamped& robot) {
  using nav2_util::geometry_utils::euclidean_distance;
  size_t closest = 0;
  double least = std::numeric_limits<double>::max();
  for (size_t i = 0; i < path.poses.size(); ++i) {
    const double distance = euclidean_distance(robot, path.poses[i]);
    if (distance >= least) continue;
    least = distance;
    closest = i;
  }
  return nav2_util::geometry_utils::calculate_path_length(path, closest);
}

double length_of_entry(const BT::Blackboard& blackboard, const std::string& path_id,
                       const PoseStamped& robot) {
  nav_msgs::msg::Path path;
  try {
    if (blackboard.get(path_id, path) && !path.poses.empty()) return length_ahead(path, robot);
  } catch (const std::exception&) {
    // A tree may use the name for something else.
  }
  return 0.0;
}

bool to_global_frame(const nav2_core::FeedbackUtils& utils, const rclcpp::Logger& logger,
                     PoseStamped& goal) {
  const std::string frame = goal.header.frame_id;
  if (nav2_util::transformPoseInTargetFrame(goal, goal, *utils.tf, utils.global_frame,
                                            utils.transform_tolerance)) {
    return true;
  }
  RCLCPP_ERROR(
      logger,
      "Failed to transform a goal pose provided with frame_id '%s' to the global frame '%s'.",
      frame.c_str(), utils.global_frame.c_str());
  return false;
}

}  // namespace nav2_bt_navigator
