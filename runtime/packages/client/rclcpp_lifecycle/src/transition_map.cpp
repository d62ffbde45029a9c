// The states of a managed node and the steps between them.
#include "transition_map.hpp"

#include <algorithm>

#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"

namespace rclcpp_lifecycle {
namespace {

using S = lifecycle_msgs::msg::State;
using T = lifecycle_msgs::msg::Transition;

template <typename Predicate>
const TransitionRow* first(const Predicate& matches) {
  const auto found = std::find_if(kTransitions.begin(), kTransitions.end(), matches);
  return found == kTransitions.end() ? nullptr : &*found;
}

}  // namespace

constexpr std::array<StateRow, 11> kStates = {{
    {S::PRIMARY_STATE_UNKNOWN, "unknown"},
    {S::PRIMARY_STATE_UNCONFIGURED, "unconfigured"},
    {S::PRIMARY_STATE_INACTIVE, "inactive"},
    {S::PRIMARY_STATE_ACTIVE, "active"},
    {S::PRIMARY_STATE_FINALIZED, "finalized"},
    {S::TRANSITION_STATE_CONFIGURING, "configuring"},
    {S::TRANSITION_STATE_CLEANINGUP, "cleaningup"},
    {S::TRANSITION_STATE_SHUTTINGDOWN, "shuttingdown"},
    {S::TRANSITION_STATE_ACTIVATING, "activating"},
    {S::TRANSITION_STATE_DEACTIVATING, "deactivating"},
    {S::TRANSITION_STATE_ERRORPROCESSING, "errorprocessing"},
}};

constexpr std::array<TransitionRow, 25> kTransitions = {{
    {T::TRANSITION_CONFIGURE, "configure", S::PRIMARY_STATE_UNCONFIGURED,
     S::TRANSITION_STATE_CONFIGURING},
    {T::TRANSITION_ON_CONFIGURE_SUCCESS, kSuccessLabel, S::TRANSITION_STATE_CONFIGURING,
     S::PRIMARY_STATE_INACTIVE},
    {T::TRANSITION_ON_CONFIGURE_FAILURE, kFailureLabel, S::TRANSITION_STATE_CONFIGURING,
     S::PRIMARY_STATE_UNCONFIGURED},
    {T::TRANSITION_ON_CONFIGURE_ERROR, kErrorLabel, S::TRANSITION_STATE_CONFIGURING,
     S::TRANSITION_STATE_ERRORPROCESSING},
    {T::TRANSITION_CLEANUP, "cleanup", S::PRIMARY_STATE_INACTIVE, S::TRANSITION_STATE_CLEANINGUP},
    {T::TRANSITION_ON_CLEANUP_SUCCESS, kSuccessLabel, S::TRANSITION_STATE_CLEANINGUP,
     S::PRIMARY_STATE_UNCONFIGURED},
    {T::TRANSITION_ON_CLEANUP_FAILURE, kFailureLabel, S::TRANSITION_STATE_CLEANINGUP,
     S::PRIMARY_STATE_INACTIVE},
    {T::TRANSITION_ON_CLEANUP_ERROR, kErrorLabel, S::TRANSITION_STATE_CLEANINGUP,
     S::TRANSITION_STATE_ERRORPROCESSING},
    {T::TRANSITION_ACTIVATE, "activate", S::PRIMARY_STATE_INACTIVE, S::TRANSITION_STATE_ACTIVATING},
    {T::TRANSITION_ON_ACTIVATE_SUCCESS, kSuccessLabel, S::TRANSITION_STATE_ACTIVATING,
     S::PRIMARY_STATE_ACTIVE},
    {T::TRANSITION_ON_ACTIVATE_FAILURE, kFailureLabel, S::TRANSITION_STATE_ACTIVATING,
     S::PRIMARY_STATE_INACTIVE},
    {T::TRANSITION_ON_ACTIVATE_ERROR, kErrorLabel, S::TRANSITION_STATE_ACTIVATING,
     S::TRANSITION_STATE_ERRORPROCESSING},
    {T::TRANSITION_DEACTIVATE, "deactivate", S::PRIMARY_STATE_ACTIVE,
     S::TRANSITION_STATE_DEACTIVATING},
    {T::TRANSITION_ON_DEACTIVATE_SUCCESS, kSuccessLabel, S::TRANSITION_STATE_DEACTIVATING,
     S::PRIMARY_STATE_INACTIVE},
    {T::TRANSITION_ON_DEACTIVATE_FAILURE, kFailureLabel, S::TRANSITION_STATE_DEACTIVATING,
     S::PRIMARY_STATE_ACTIVE},
    {T::TRANSITION_ON_DEACTIVATE_ERROR, kErrorLabel, S::TRANSITION_STATE_DEACTIVATING,
     S::TRANSITION_STATE_ERRORPROCESSING},
    {T::TRANSITION_UNCONFIGURED_SHUTDOWN, kShutdownLabel, S::PRIMARY_STATE_UNCONFIGURED,
     S::TRANSITION_STATE_SHUTTINGDOWN},
    {T::TRANSITION_INACTIVE_SHUTDOWN, kShutdownLabel, S::PRIMARY_STATE_INACTIVE,
     S::TRANSITION_STATE_SHUTTINGDOWN},
    {T::TRANSITION_ACTIVE_SHUTDOWN, kShutdownLabel, S::PRIMARY_STATE_ACTIVE,
     S::TRANSITION_STATE_SHUTTINGDOWN},
    {T::TRANSITION_ON_SHUTDOWN_SUCCESS, kSuccessLabel, S::TRANSITION_STATE_SHUTTINGDOWN,
     S::PRIMARY_STATE_FINALIZED},
    {T::TRANSITION_ON_SHUTDOWN_FAILURE, kFailureLabel, S::TRANSITION_STATE_SHUTTINGDOWN,
     S::PRIMARY_STATE_FINALIZED},
    {T::TRANSITION_ON_SHUTDOWN_ERROR, kErrorLabel, S::TRANSITION_STATE_SHUTTINGDOWN,
     S::TRANSITION_STATE_ERRORPROCESSING},
    {T::TRANSITION_ON_ERROR_SUCCESS, kSuccessLabel, S::TRANSITION_STATE_ERRORPROCESSING,
     S::PRIMARY_STATE_UNCONFIGURED},
    {T::TRANSITION_ON_ERROR_FAILURE, kFailureLabel, S::TRANSITION_STATE_ERRORPROCESSING,
     S::PRIMARY_STATE_FINALIZED},
    {T::TRANSITION_ON_ERROR_ERROR, kErrorLabel, S::TRANSITION_STATE_ERRORPROCESSING,
     S::PRIMARY_STATE_FINALIZED},
}};

const TransitionRow* find_transition(uint8_t start, uint8_t id) {
  return first([&](const TransitionRow& row) { return row.start == start && row.id == id; });
}

const TransitionRow* find_transition(uint8_t start, std::string_view label) {
  return first([&](const TransitionRow& row) { return row.start == start && row.label == label; });
}

State state_of(uint8_t id) {
  const auto found =
      std::find_if(kStates.begin(), kStates.end(), [&](const auto& row) { return row.id == id; });
  return State(found->id, found->label);
}

Transition transition_of(const TransitionRow& row) {
  return Transition(row.id, row.label, state_of(row.start), state_of(row.goal));
}

}  // namespace rclcpp_lifecycle
