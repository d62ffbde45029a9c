// See collision_monitor_node.hpp. The states of the node; its work is in monitoring.cpp.
#include "nav2_collision_monitor/collision_monitor_node.hpp"

#include "rclcpp_components/register_node_macro.hpp"
#include "read_parameters.hpp"

namespace nav2_collision_monitor {

using nav2_util::CallbackReturn;

namespace {

// Moves: a robot that stands from the beginning has just stopped.
const Action kNoAction{DO_NOTHING, {-1.0, -1.0, -1.0}, ""};

}  // namespace

CollisionMonitor::CollisionMonitor(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("collision_monitor", "", options),
      robot_action_prev_(kNoAction),
      stop_stamp_(0, 0, get_clock()->get_clock_type()) {}

CollisionMonitor::~CollisionMonitor() = default;

CallbackReturn CollisionMonitor::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring");
  std::string in_topic;
  std::string out_topic;
  std::string state_topic;
  if (!getParameters(in_topic, out_topic, state_topic)) {
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }
  createTopics(in_topic, out_topic, state_topic);
  if (read<bool>(shared_from_this(), "use_realtime_priority", false)) {
    nav2_util::setSoftRealTimePriority();
  }
  return CallbackReturn::SUCCESS;
}

bool CollisionMonitor::getParameters(std::string& in_topic, std::string& out_topic,
                                     std::string& state_topic) {
  const NodePtr node = shared_from_this();
  try {
    in_topic = read<std::string>(node, "cmd_vel_in_topic", "cmd_vel_smoothed");
    out_topic = read<std::string>(node, "cmd_vel_out_topic", "cmd_vel");
    state_topic = read<std::string>(node, "state_topic", "");
    stop_pub_timeout_ =
        rclcpp::Duration::from_seconds(read_number(node, "stop_pub_timeout", 1.0, 0.0));
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "Error while getting parameters: %s", error.what());
    return false;
  }
  return zones_.configure(node);
}

void CollisionMonitor::createTopics(const std::string& in_topic, const std::string& out_topic,
                                    const std::string& state_topic) {
  cmd_vel_in_sub_ = std::make_unique<nav2_util::TwistSubscriber>(
      shared_from_this(), in_topic, 1,
      [this](geometry_msgs::msg::Twist::SharedPtr message) { cmdVelInCallbackUnstamped(message); },
      [this](geometry_msgs::msg::TwistStamped::SharedPtr message) {
        cmdVelInCallbackStamped(message);
      });
  cmd_vel_out_pub_ = std::make_unique<nav2_util::TwistPublisher>(shared_from_this(), out_topic, 1);
  if (!state_topic.empty()) state_pub_ = create_publisher<State>(state_topic, 1);
  collision_points_marker_pub_ = create_publisher<MarkerArray>("~/collision_points_marker", 1);
  toggle_cm_service_ = create_service<Toggle>(
      "~/toggle",
      [this](const Toggle::Request::SharedPtr request, Toggle::Response::SharedPtr response) {
        enabled_ = request->enable;
        response->success = true;
        response->message =
            std::string("Collision monitor toggled ") + (enabled_ ? "on" : "off") + " successfully";
      });
}

CallbackReturn CollisionMonitor::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  cmd_vel_out_pub_->on_activate();
  if (state_pub_) state_pub_->on_activate();
  collision_points_marker_pub_->on_activate();
  zones_.activate();
  // Later they are published whenever a velocity comes.
  zones_.publish();
  process_active_ = true;
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CollisionMonitor::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  process_active_ = false;
  robot_action_prev_ = kNoAction;
  zones_.deactivate();
  cmd_vel_out_pub_->on_deactivate();
  if (state_pub_) state_pub_->on_deactivate();
  collision_points_marker_pub_->on_deactivate();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CollisionMonitor::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  cmd_vel_in_sub_.reset();
  cmd_vel_out_pub_.reset();
  state_pub_.reset();
  collision_points_marker_pub_.reset();
  toggle_cm_service_.reset();
  invalid_source_ = nullptr;
  zones_.clear();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CollisionMonitor::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

}  // namespace nav2_collision_monitor

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_collision_monitor::CollisionMonitor)
