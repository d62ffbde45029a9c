// See delay_node.hpp.
#include "delay_node.hpp"

#include "rclcpp_components/register_node_macro.hpp"

namespace topic_tools {

DelayNode::DelayNode(const rclcpp::NodeOptions& options) : ToolBaseNode("delay", options) {
  input_topic_ = declare_parameter<std::string>("input_topic");
  output_topic_ = declare_parameter<std::string>("output_topic", input_topic_ + "_delay");
  lazy_ = declare_parameter<bool>("lazy", false);
  delay_ = rclcpp::Duration::from_seconds(declare_parameter("delay", 0.0));
  const bool use_wall_clock = declare_parameter("use_wall_clock", false);
  clock_ = use_wall_clock ? std::make_shared<rclcpp::Clock>() : get_clock();
  start();
}

void DelayNode::process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) {
  const auto place = timers_.insert(timers_.end(), nullptr);
  *place = rclcpp::create_timer(this, clock_, delay_, [this, place, message] {
    send(*message);
    timers_.erase(place);
  });
}

}  // namespace topic_tools

RCLCPP_COMPONENTS_REGISTER_NODE(topic_tools::DelayNode)
