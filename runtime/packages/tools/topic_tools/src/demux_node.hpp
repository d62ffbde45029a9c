// Passes messages on to the selected one of several topics.
#pragma once

#include "selection_services.hpp"
#include "tool_base_node.hpp"
#include "topic_tools_interfaces/srv/demux_add.hpp"
#include "topic_tools_interfaces/srv/demux_delete.hpp"
#include "topic_tools_interfaces/srv/demux_list.hpp"
#include "topic_tools_interfaces/srv/demux_select.hpp"

namespace topic_tools {

class DemuxNode : public ToolBaseNode {
 public:
  explicit DemuxNode(const rclcpp::NodeOptions& options);

 private:
  struct Services {
    using Add = topic_tools_interfaces::srv::DemuxAdd;
    using Delete = topic_tools_interfaces::srv::DemuxDelete;
    using List = topic_tools_interfaces::srv::DemuxList;
    using Select = topic_tools_interfaces::srv::DemuxSelect;
  };
  void process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) override;
  void follow_selection();

  std::optional<TopicSelection> selection_;
  std::optional<SelectionServices<Services>> services_;
};

}  // namespace topic_tools
