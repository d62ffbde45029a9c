// The ranges that limits leave to the next command of one joint.
#pragma once

#include <optional>
#include <string>

#include "joint_limits/data_structures.hpp"
#include "joint_limits/joint_limits.hpp"

namespace joint_limits {

namespace internal {
/// Radians or metres. Within the first, a joint outside its limits may be led back.
constexpr double POSITION_BOUNDS_TOLERANCE = 0.002;
constexpr double OUT_OF_BOUNDS_EXCEPTION_TOLERANCE = 0.0087;
}  // namespace internal

/// Copies the values of `desired` that are set and not NaN.
void update_prev_command(const JointControlInterfacesData& desired,
                         JointControlInterfacesData& prev_command);

bool is_limited(double value, double min, double max);

/// `dt` is in seconds. Throws std::runtime_error when the actual position is out of bounds by more
/// than the tolerance.
PositionLimits compute_position_limits(const std::string& joint_name, const JointLimits& limits,
                                       const std::optional<double>& act_vel,
                                       const std::optional<double>& act_pos,
                                       const std::optional<double>& prev_command_pos, double dt);
VelocityLimits compute_velocity_limits(const std::string& joint_name, const JointLimits& limits,
                                       const double& desired_vel,
                                       const std::optional<double>& act_pos,
                                       const std::optional<double>& prev_command_vel, double dt);
EffortLimits compute_effort_limits(const JointLimits& limits, const std::optional<double>& act_pos,
                                   const std::optional<double>& act_vel, double dt);
AccelerationLimits compute_acceleration_limits(const JointLimits& limits,
                                               double desired_acceleration,
                                               std::optional<double> actual_velocity);

/// Brings `desired` into the limits of one joint, and notes it in `previous` (which starts with
/// the actual values). True when a value was changed; nothing happens when `dt` is not positive.
bool saturate(const std::string& joint_name, const JointLimits& limits,
              const JointControlInterfacesData& actual, JointControlInterfacesData& desired,
              JointControlInterfacesData& previous, double dt);

}  // namespace joint_limits
