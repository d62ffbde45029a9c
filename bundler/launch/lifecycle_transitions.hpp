// The transitions of managed nodes that can be asked for, as lifecycle_msgs/msg/Transition numbers
// them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ros2wasm {

struct LifecycleTransitionRow {
  std::int64_t id = 0;
  std::string_view label;
};

constexpr std::array<LifecycleTransitionRow, 9> kTransitions{{{0, "create"},
                                                              {1, "configure"},
                                                              {2, "cleanup"},
                                                              {3, "activate"},
                                                              {4, "deactivate"},
                                                              {5, "unconfigured_shutdown"},
                                                              {6, "inactive_shutdown"},
                                                              {7, "active_shutdown"},
                                                              {8, "destroy"}}};

}  // namespace ros2wasm
