// The callbacks of a managed node's transitions. Each gets the state before the transition.
#pragma once

#include <cstdint>

#include "lifecycle_msgs/msg/transition.hpp"
#include "rclcpp/node_interfaces/detail/node_interfaces_helpers.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "rclcpp_lifecycle/visibility_control.h"

namespace rclcpp_lifecycle {
namespace node_interfaces {

class LifecycleNodeInterface {
 public:
  enum class CallbackReturn : uint8_t {
    SUCCESS = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_SUCCESS,
    FAILURE = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_FAILURE,
    ERROR = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_ERROR
  };

  virtual ~LifecycleNodeInterface() = default;
  virtual CallbackReturn on_configure(const State& previous_state);
  virtual CallbackReturn on_cleanup(const State& previous_state);
  virtual CallbackReturn on_shutdown(const State& previous_state);
  virtual CallbackReturn on_activate(const State& previous_state);
  virtual CallbackReturn on_deactivate(const State& previous_state);
  /// After a callback that returned ERROR or threw. SUCCESS: the node is unconfigured again,
  /// else it is finalized.
  virtual CallbackReturn on_error(const State& previous_state);

 protected:
  LifecycleNodeInterface() = default;
};

}  // namespace node_interfaces
}  // namespace rclcpp_lifecycle

RCLCPP_NODE_INTERFACE_HELPERS_SUPPORT(rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface,
                                      lifecycle_node)
