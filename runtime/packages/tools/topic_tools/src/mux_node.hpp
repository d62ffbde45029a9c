// Passes on what comes from the selected one of several topics.
#pragma once

#include "selection_services.hpp"
#include "tool_base_node.hpp"
#include "topic_tools_interfaces/srv/mux_add.hpp"
#include "topic_tools_interfaces/srv/mux_delete.hpp"
#include "topic_tools_interfaces/srv/mux_list.hpp"
#include "topic_tools_interfaces/srv/mux_select.hpp"

namespace topic_tools {

class MuxNode : public ToolBaseNode {
 public:
  explicit MuxNode(const rclcpp::NodeOptions& options);

 private:
  struct Services {
    using Add = topic_tools_interfaces::srv::MuxAdd;
    using Delete = topic_tools_interfaces::srv::MuxDelete;
    using List = topic_tools_interfaces::srv::MuxList;
    using Select = topic_tools_interfaces::srv::MuxSelect;
  };
  void process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) override;
  void follow_selection();

  std::optional<TopicSelection> selection_;
  std::optional<SelectionServices<Services>> services_;
};

}  // namespace topic_tools
