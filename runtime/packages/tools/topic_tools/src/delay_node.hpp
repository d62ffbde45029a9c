// Passes messages on after a while.
#pragma once

#include <list>

#include "tool_base_node.hpp"

namespace topic_tools {

class DelayNode : public ToolBaseNode {
 public:
  explicit DelayNode(const rclcpp::NodeOptions& options);

 private:
  void process_message(const std::shared_ptr<rclcpp::SerializedMessage>& message) override;

  rclcpp::Duration delay_{0, 0};
  rclcpp::Clock::SharedPtr clock_;
  /// One for each message that waits.
  std::list<rclcpp::TimerBase::SharedPtr> timers_;
};

}  // namespace topic_tools
