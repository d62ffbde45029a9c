// A state of a managed node: one of lifecycle_msgs/msg/State, or a user's own.
#pragma once

#include <cstdint>
#include <string>

#include "rclcpp_lifecycle/visibility_control.h"
#include "rcutils/allocator.h"

namespace rclcpp_lifecycle {

class State {
 public:
  /// The state "unknown".
  explicit State(rcutils_allocator_t allocator = rcutils_get_default_allocator());
  /// Throws std::runtime_error for an empty label.
  State(uint8_t id, const std::string& label,
        rcutils_allocator_t allocator = rcutils_get_default_allocator());
  State(const State& rhs) = default;
  State& operator=(const State& rhs) = default;
  virtual ~State() = default;

  uint8_t id() const { return id_; }
  std::string label() const { return label_; }

 private:
  uint8_t id_;
  std::string label_;
};

}  // namespace rclcpp_lifecycle
