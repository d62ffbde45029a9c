// See throttle_node.hpp.
#include "throttle_node.hpp"

#include "rclcpp_components/register_node_macro.hpp"

namespace topic_tools {

ThrottleNode::ThrottleNode(const rclcpp::NodeOptions& options) : ToolBaseNode("throttle", options) {
  input_topic_ = declare_parameter<std::string>("input_topic");
  output_topic_ = declare_parameter<std::string>("output_topic", input_topic_ + "_throttle");
  lazy_ = declare_parameter<bool>("lazy", false);
  const std::string kind = declare_parameter<std::string>("throttle_type");
  int64_t period_ns = 0;
  if (kind == "messages") {
    period_ns = rclcpp::Rate(declare_parameter<double>("msgs_per_sec")).period().count();
  } else if (kind == "bytes") {
    const int64_t most = declare_parameter<int>("bytes_per_sec");
    bytes_.emplace(most, declare_parameter<double>("window"));
  } else {
    RCLCPP_ERROR(get_logger(), "Unknown throttle type");
    return;
  }
  use_wall_clock_ = declare_parameter("use_wall_clock", false);
  if (!bytes_) messages_.emplace(period_ns, time().nanoseconds());
  start();
}

rclcpp::Time ThrottleNode::time() {
  return use_wall_clock_ ? wall_clock_.now() : now();
}

void ThrottleNode::process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) {
  const rclcpp::Time now = time();
  if (bytes_) {
    if (bytes_->passes(now.seconds(), message->size())) send(*message);
    return;
  }
  if (messages_->is_back_in_time(now.nanoseconds())) {
    RCLCPP_WARN(get_logger(), "Detected jump back in time, resetting throttle period to now for.");
    messages_->restart(now.nanoseconds());
  }
  if (messages_->passes(now.nanoseconds())) send(*message);
}

}  // namespace topic_tools

RCLCPP_COMPONENTS_REGISTER_NODE(topic_tools::ThrottleNode)
