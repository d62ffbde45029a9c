// A node's waitables, for real.
#pragma once

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_waitables_interface.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeWaitables : public NodeWaitablesInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeWaitables)
  explicit NodeWaitables(NodeBaseInterface* node_base) : node_base_(node_base) {}
  void add_waitable(rclcpp::Waitable::SharedPtr waitable_base_ptr,
                    rclcpp::CallbackGroup::SharedPtr group) override;
  void remove_waitable(rclcpp::Waitable::SharedPtr waitable_ptr,
                       rclcpp::CallbackGroup::SharedPtr group) noexcept override;

 private:
  RCLCPP_DISABLE_COPY(NodeWaitables)
  NodeBaseInterface* node_base_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
