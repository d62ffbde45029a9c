// Whether a gripper is where it shall be, or does not get on. Knows nothing of ROS.
#pragma once

#include <cmath>
#include <cstdint>

namespace gripper_controllers {

struct GripLimits {
  double goal_tolerance = 0.01;             ///< [m] or [rad]
  double stall_velocity_threshold = 0.001;  ///< per second
  double stall_timeout = 1.0;               ///< [s]
};

enum class GripState : uint8_t { kMoving, kReached, kStalled };

class Grip {
 public:
  void start(int64_t now_ns) { last_movement_ns_ = now_ns; }

  GripState look(int64_t now_ns, double error, double velocity, const GripLimits& limits) {
    if (std::abs(error) < limits.goal_tolerance) return GripState::kReached;
    if (std::abs(velocity) > limits.stall_velocity_threshold) last_movement_ns_ = now_ns;
    const double still_s = static_cast<double>(now_ns - last_movement_ns_) * 1e-9;
    return still_s > limits.stall_timeout ? GripState::kStalled : GripState::kMoving;
  }

 private:
  int64_t last_movement_ns_ = 0;
};

}  // namespace gripper_controllers
