// A step from one state of a managed node to another.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rclcpp_lifecycle/state.hpp"
#include "rclcpp_lifecycle/visibility_control.h"
#include "rcutils/allocator.h"

namespace rclcpp_lifecycle {

class Transition {
 public:
  Transition() = delete;
  explicit Transition(uint8_t id, const std::string& label = "",
                      rcutils_allocator_t allocator = rcutils_get_default_allocator());
  Transition(uint8_t id, const std::string& label, State&& start, State&& goal,
             rcutils_allocator_t allocator = rcutils_get_default_allocator());
  Transition(const Transition& rhs) = default;
  Transition& operator=(const Transition& rhs) = default;
  virtual ~Transition() = default;

  uint8_t id() const { return id_; }
  std::string label() const { return label_; }
  /// The states throw std::runtime_error when the transition was made without them.
  State start_state() const;
  State goal_state() const;

 private:
  uint8_t id_;
  std::string label_;
  std::optional<State> start_;
  std::optional<State> goal_;
};

}  // namespace rclcpp_lifecycle
