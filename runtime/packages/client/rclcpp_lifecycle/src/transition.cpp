// A step from one state of a managed node to another.
#include "rclcpp_lifecycle/transition.hpp"

#include <stdexcept>
#include <utility>

namespace rclcpp_lifecycle {
namespace {

State present(const std::optional<State>& state) {
  if (!state) {
    throw std::runtime_error("rcl_lifecycle_state_handle is null");
  }
  return *state;
}

}  // namespace

Transition::Transition(uint8_t id, const std::string& label, rcutils_allocator_t)
    : id_(id), label_(label) {}

Transition::Transition(uint8_t id, const std::string& label, State&& start, State&& goal,
                       rcutils_allocator_t)
    : id_(id), label_(label), start_(std::move(start)), goal_(std::move(goal)) {}

State Transition::start_state() const {
  return present(start_);
}

State Transition::goal_state() const {
  return present(goal_);
}

}  // namespace rclcpp_lifecycle
