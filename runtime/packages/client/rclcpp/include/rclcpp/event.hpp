// A flag that says that something happened since it was last asked.
#pragma once

#include <atomic>

#include "rclcpp/macros.hpp"

namespace rclcpp {

class Event {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Event)
  Event() = default;
  bool set() { return state_.exchange(true); }
  bool check() { return state_; }
  bool check_and_clear() { return state_.exchange(false); }

 private:
  RCLCPP_DISABLE_COPY(Event)
  std::atomic_bool state_{false};
};

}  // namespace rclcpp
