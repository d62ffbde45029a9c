// The states of a managed node and the steps between them, as lifecycle_msgs numbers them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "rclcpp_lifecycle/state.hpp"
#include "rclcpp_lifecycle/transition.hpp"

namespace rclcpp_lifecycle {

struct StateRow {
  uint8_t id;
  const char* label;
};

struct TransitionRow {
  uint8_t id;
  const char* label;
  uint8_t start;
  uint8_t goal;
};

inline constexpr char kShutdownLabel[] = "shutdown";
inline constexpr char kSuccessLabel[] = "transition_success";
inline constexpr char kFailureLabel[] = "transition_failure";
inline constexpr char kErrorLabel[] = "transition_error";

/// In the order in which tools list them.
extern const std::array<StateRow, 11> kStates;
extern const std::array<TransitionRow, 25> kTransitions;

/// The transition with that number or label that starts at a state; null: there is none.
const TransitionRow* find_transition(uint8_t start, uint8_t id);
const TransitionRow* find_transition(uint8_t start, std::string_view label);

/// For a number of kStates only.
State state_of(uint8_t id);
Transition transition_of(const TransitionRow& row);

}  // namespace rclcpp_lifecycle
