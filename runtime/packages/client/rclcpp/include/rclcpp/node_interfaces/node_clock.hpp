// A node's clock, for real.
#pragma once

#include <memory>

#include "rclcpp/node_interfaces/node_clock_interface.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeClock : public NodeClockInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeClock)
  explicit NodeClock(rcl_clock_type_t clock_type)
      : clock_(std::make_shared<rclcpp::Clock>(clock_type)) {}
  rclcpp::Clock::SharedPtr get_clock() override { return clock_; }
  rclcpp::Clock::ConstSharedPtr get_clock() const override { return clock_; }

 private:
  RCLCPP_DISABLE_COPY(NodeClock)
  rclcpp::Clock::SharedPtr clock_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
