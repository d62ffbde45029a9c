// See demux_node.hpp.
#include "demux_node.hpp"

#include <vector>

#include "rclcpp_components/register_node_macro.hpp"

namespace topic_tools {

DemuxNode::DemuxNode(const rclcpp::NodeOptions& options) : ToolBaseNode("demux", options) {
  const std::string initial_topic = declare_parameter("initial_topic", "");
  input_topic_ = declare_parameter("input_topic", "~/input");
  selection_.emplace(declare_parameter<std::vector<std::string>>("output_topics"), initial_topic,
                     [this](const std::string& topic) {
                       return get_node_topics_interface()->resolve_topic_name(topic);
                     });
  follow_selection();
  start();
  services_.emplace(*this, "demux", *selection_, [this] { follow_selection(); });
}

void DemuxNode::follow_selection() {
  output_topic_ = selection_->has_selected() ? selection_->selected() : std::string();
  look();
}

void DemuxNode::process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) {
  send(*message);
}

}  // namespace topic_tools

RCLCPP_COMPONENTS_REGISTER_NODE(topic_tools::DemuxNode)
