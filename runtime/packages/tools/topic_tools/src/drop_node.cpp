// See drop_node.hpp.
#include "drop_node.hpp"

#include "rclcpp_components/register_node_macro.hpp"

namespace topic_tools {

DropNode::DropNode(const rclcpp::NodeOptions& options) : ToolBaseNode("drop", options) {
  input_topic_ = declare_parameter<std::string>("input_topic");
  output_topic_ = declare_parameter<std::string>("output_topic", input_topic_ + "_drop");
  lazy_ = declare_parameter<bool>("lazy", false);
  const int64_t dropped = declare_parameter<int>("X");
  const int64_t of = declare_parameter<int>("Y");
  rule_.emplace(dropped, of);
  start();
}

void DropNode::process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) {
  if (rule_->passes()) send(*message);
}

}  // namespace topic_tools

RCLCPP_COMPONENTS_REGISTER_NODE(topic_tools::DropNode)
