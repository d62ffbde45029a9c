// Transitions of controllers in tests: true when the controller got to the state.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "lifecycle_msgs/msg/state.hpp"
#include "rclcpp_lifecycle/state.hpp"

namespace controller_interface {

using lifecycle_msgs::msg::State;

namespace detail {
inline bool got_to(const rclcpp_lifecycle::State& state, uint8_t wanted, uint8_t before,
                   const char* where) {
  if (state.id() != wanted && state.id() != before) {
    throw std::runtime_error(std::string("Unexpected controller state in ") + where + ": " +
                             std::to_string(state.id()));
  }
  return state.id() == wanted;
}
}  // namespace detail

template <typename T>
bool configure_succeeds(const std::unique_ptr<T>& controller) {
  return detail::got_to(controller->configure(), State::PRIMARY_STATE_INACTIVE,
                        State::PRIMARY_STATE_UNCONFIGURED, "configure_succeeds");
}
template <typename T>
bool activate_succeeds(const std::unique_ptr<T>& controller) {
  return detail::got_to(controller->get_node()->activate(), State::PRIMARY_STATE_ACTIVE,
                        State::PRIMARY_STATE_INACTIVE, "activate_succeeds");
}
template <typename T>
bool deactivate_succeeds(const std::unique_ptr<T>& controller) {
  return detail::got_to(controller->get_node()->deactivate(), State::PRIMARY_STATE_INACTIVE,
                        State::PRIMARY_STATE_ACTIVE, "deactivate_succeeds");
}
template <typename T>
bool cleanup_succeeds(const std::unique_ptr<T>& controller) {
  return detail::got_to(controller->get_node()->cleanup(), State::PRIMARY_STATE_UNCONFIGURED,
                        State::PRIMARY_STATE_INACTIVE, "cleanup_succeeds");
}
template <typename T>
bool shutdown_succeeds(const std::unique_ptr<T>& controller) {
  return detail::got_to(controller->get_node()->shutdown(), State::PRIMARY_STATE_FINALIZED,
                        State::PRIMARY_STATE_FINALIZED, "shutdown_succeeds");
}

}  // namespace controller_interface
