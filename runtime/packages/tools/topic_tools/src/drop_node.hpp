// Passes on some of every so many messages.
#pragma once

#include "flow_rules.hpp"
#include "tool_base_node.hpp"

namespace topic_tools {

class DropNode : public ToolBaseNode {
 public:
  explicit DropNode(const rclcpp::NodeOptions& options);

 private:
  void process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) override;

  std::optional<DropRule> rule_;
};

}  // namespace topic_tools
