// The results of one cycle of a hardware component.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace hardware_interface {

enum class return_type : std::uint8_t {
  OK = 0,
  ERROR = 1,
  DEACTIVATE = 2,  ///< from write: the component and its controllers are deactivated
};

struct HardwareComponentCycleStatus {
  bool successful = true;
  return_type result = return_type::OK;
  std::optional<std::chrono::nanoseconds> execution_time = std::nullopt;
};

}  // namespace hardware_interface
