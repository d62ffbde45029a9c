// See relay_node.hpp.
#include "relay_node.hpp"

#include "rclcpp_components/register_node_macro.hpp"

namespace topic_tools {

RelayNode::RelayNode(const rclcpp::NodeOptions& options) : ToolBaseNode("relay", options) {
  input_topic_ = declare_parameter<std::string>("input_topic");
  output_topic_ = declare_parameter<std::string>("output_topic", input_topic_ + "_relay");
  lazy_ = declare_parameter<bool>("lazy", false);
  start();
}

void RelayNode::process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) {
  send(*message);
}

}  // namespace topic_tools

RCLCPP_COMPONENTS_REGISTER_NODE(topic_tools::RelayNode)
