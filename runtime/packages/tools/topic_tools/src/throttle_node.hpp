// Passes messages on up to a rate, or up to a bandwidth.
#pragma once

#include "flow_rules.hpp"
#include "tool_base_node.hpp"

namespace topic_tools {

class ThrottleNode : public ToolBaseNode {
 public:
  explicit ThrottleNode(const rclcpp::NodeOptions& options);

 private:
  void process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) override;

  rclcpp::Time time();

  bool use_wall_clock_ = false;
  rclcpp::Clock wall_clock_;
  std::optional<MessageThrottle> messages_;
  std::optional<ByteThrottle> bytes_;
};

}  // namespace topic_tools
