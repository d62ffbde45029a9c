// A node's timers, for real.
#pragma once

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_timers_interface.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeTimers : public NodeTimersInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTimers)
  explicit NodeTimers(NodeBaseInterface* node_base) : node_base_(node_base) {}
  void add_timer(rclcpp::TimerBase::SharedPtr timer,
                 rclcpp::CallbackGroup::SharedPtr callback_group) override;

 private:
  RCLCPP_DISABLE_COPY(NodeTimers)
  NodeBaseInterface* node_base_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
