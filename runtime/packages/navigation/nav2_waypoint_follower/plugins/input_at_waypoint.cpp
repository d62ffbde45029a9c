// See input_at_waypoint.hpp.
#include "nav2_waypoint_follower/plugins/input_at_waypoint.hpp"

#include <stdexcept>
#include <utility>

#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_waypoint_follower {
namespace {

constexpr double kLookAgain = 50.0;  // Hz
/// A time in nanoseconds has 63 bits.
constexpr double kLongest = 9.0e9;  // s

}  // namespace

void InputAtWaypoint::initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                 const std::string& plugin_name) {
  const auto node = parent.lock();
  if (!node) throw std::runtime_error{"Failed to lock node in input at waypoint plugin!"};
  logger_ = node->get_logger();
  clock_ = node->get_clock();
  const auto read = [&node, &plugin_name](const std::string& name, const auto& value) {
    const std::string full = plugin_name + "." + name;
    nav2_util::declare_parameter_if_not_declared(node, full, rclcpp::ParameterValue(value));
    return node->get_parameter(full);
  };
  const double timeout = read("timeout", 10.0).as_double();
  if (!(timeout >= 0.0 && timeout <= kLongest)) {
    throw std::runtime_error{plugin_name + ".timeout must be from 0 to 9e9 seconds"};
  }
  timeout_ = rclcpp::Duration::from_seconds(timeout);
  is_enabled_ = read("enabled", true).as_bool();
  const std::string topic = read("input_topic", "input_at_waypoint/input").as_string();
  RCLCPP_INFO(logger_, "InputAtWaypoint: Subscribing to input topic %s.", topic.c_str());
  subscription_ = node->create_subscription<std_msgs::msg::Empty>(
      topic, 1, [this](const std_msgs::msg::Empty::SharedPtr msg) { Cb(msg); });
}

void InputAtWaypoint::Cb(const std_msgs::msg::Empty::SharedPtr) {
  const std::lock_guard<std::mutex> lock(mutex_);
  input_received_ = true;
}

bool InputAtWaypoint::isReceived() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return input_received_;
}

bool InputAtWaypoint::processAtWaypoint(const geometry_msgs::msg::PoseStamped&,
                                        const int& curr_waypoint_index) {
  if (!is_enabled_) return true;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    input_received_ = false;
  }
  const rclcpp::Time start = clock_->now();
  rclcpp::Rate rate(kLookAgain);
  while (rclcpp::ok() && clock_->now() - start < timeout_) {
    if (isReceived()) return true;
    rate.sleep();
  }
  RCLCPP_WARN(logger_, "Unable to get external input at wp %i. Moving on.", curr_waypoint_index);
  return false;
}

}  // namespace nav2_waypoint_follower

PLUGINLIB_EXPORT_CLASS(nav2_waypoint_follower::InputAtWaypoint, nav2_core::WaypointTaskExecutor)
