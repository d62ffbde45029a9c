// States in which a component is neither read nor written.
#pragma once

#include "lifecycle_msgs/msg/state.hpp"

namespace hardware_interface {

constexpr bool lifecycleStateThatRequiresNoAction(const std::uint8_t state) {
  return state == lifecycle_msgs::msg::State::PRIMARY_STATE_UNKNOWN ||
         state == lifecycle_msgs::msg::State::PRIMARY_STATE_UNCONFIGURED ||
         state == lifecycle_msgs::msg::State::PRIMARY_STATE_FINALIZED;
}

}  // namespace hardware_interface
