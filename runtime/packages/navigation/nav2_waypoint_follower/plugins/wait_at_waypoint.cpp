// See wait_at_waypoint.hpp.
#include "nav2_waypoint_follower/plugins/wait_at_waypoint.hpp"

#include <chrono>
#include <stdexcept>

#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_waypoint_follower {

void WaitAtWaypoint::initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                const std::string& plugin_name) {
  const auto node = parent.lock();
  if (!node) throw std::runtime_error{"Failed to lock node in wait at waypoint plugin!"};
  logger_ = node->get_logger();
  clock_ = node->get_clock();
  const std::string pause = plugin_name + ".waypoint_pause_duration";
  const std::string enabled = plugin_name + ".enabled";
  nav2_util::declare_parameter_if_not_declared(node, pause, rclcpp::ParameterValue(0));
  nav2_util::declare_parameter_if_not_declared(node, enabled, rclcpp::ParameterValue(true));
  node->get_parameter(pause, waypoint_pause_duration_);
  node->get_parameter(enabled, is_enabled_);
  if (waypoint_pause_duration_ <= 0) {
    is_enabled_ = false;
    RCLCPP_INFO(logger_, "Waypoint pause duration is set to zero, disabling task executor plugin.");
  } else if (!is_enabled_) {
    RCLCPP_INFO(logger_, "Waypoint task executor plugin is disabled.");
  }
}

bool WaitAtWaypoint::processAtWaypoint(const geometry_msgs::msg::PoseStamped&,
                                       const int& curr_waypoint_index) {
  if (!is_enabled_) return true;
  RCLCPP_INFO(logger_, "Arrived at %i'th waypoint, sleeping for %i milliseconds",
              curr_waypoint_index, waypoint_pause_duration_);
  clock_->sleep_for(std::chrono::milliseconds(waypoint_pause_duration_));
  return true;
}

}  // namespace nav2_waypoint_follower

PLUGINLIB_EXPORT_CLASS(nav2_waypoint_follower::WaitAtWaypoint, nav2_core::WaypointTaskExecutor)
