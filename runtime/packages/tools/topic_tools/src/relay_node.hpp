// Passes every message on.
#pragma once

#include "tool_base_node.hpp"

namespace topic_tools {

class RelayNode : public ToolBaseNode {
 public:
  explicit RelayNode(const rclcpp::NodeOptions& options);

 private:
  void process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) override;
};

}  // namespace topic_tools
