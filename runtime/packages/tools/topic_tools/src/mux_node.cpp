// See mux_node.hpp.
#include "mux_node.hpp"

#include <vector>

#include "rclcpp_components/register_node_macro.hpp"

namespace topic_tools {

MuxNode::MuxNode(const rclcpp::NodeOptions& options) : ToolBaseNode("mux", options) {
  const std::string initial_topic = declare_parameter("initial_topic", "");
  output_topic_ = declare_parameter("output_topic", "~/selected");
  lazy_ = declare_parameter<bool>("lazy", false);
  selection_.emplace(declare_parameter<std::vector<std::string>>("input_topics"), initial_topic,
                     [this](const std::string& topic) {
                       return get_node_topics_interface()->resolve_topic_name(topic);
                     });
  follow_selection();
  start();
  services_.emplace(*this, "mux", *selection_, [this] { follow_selection(); });
}

void MuxNode::follow_selection() {
  input_topic_ = selection_->has_selected() ? selection_->selected() : std::string();
  look();
}

void MuxNode::process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) {
  send(*message);
}

}  // namespace topic_tools

RCLCPP_COMPONENTS_REGISTER_NODE(topic_tools::MuxNode)
