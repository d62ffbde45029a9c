// How far limits let a command go. This file needs no ROS.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "joint_limits/joint_limits_helpers.hpp"

namespace joint_limits {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename RangeT>
RangeT in_order(RangeT range) {
  if (range.lower_limit > range.upper_limit) {
    std::swap(range.lower_limit, range.upper_limit);
  }
  return range;
}

void refuse_far_outside(const std::string& joint_name, double position, const JointLimits& limits) {
  const double tolerance = internal::OUT_OF_BOUNDS_EXCEPTION_TOLERANCE;
  if (position > limits.max_position + tolerance || position < limits.min_position - tolerance) {
    throw std::runtime_error("Joint position is out of bounds for the joint : '" + joint_name +
                             "' actual position: " + std::to_string(position) + " limits: [" +
                             std::to_string(limits.min_position) + ", " +
                             std::to_string(limits.max_position) + "]");
  }
}

bool is_number(const std::optional<double>& value) {
  return value.has_value() && !std::isnan(*value);
}

/// The first reference of a value: what the joint does, else what is asked of it.
void start_with(std::optional<double>& previous, const std::optional<double>& actual,
                const std::optional<double>& desired) {
  if (!desired.has_value()) {
    return;
  }
  if (actual.has_value()) {
    previous = actual;
  } else if (is_number(desired)) {
    previous = desired;
  }
}

bool clamp_to(std::optional<double>& value, double lower, double upper) {
  const bool limited = is_limited(*value, lower, upper);
  value = std::clamp(*value, lower, upper);
  return limited;
}

}  // namespace

void update_prev_command(const JointControlInterfacesData& desired,
                         JointControlInterfacesData& prev_command) {
  const auto take = [](const std::optional<double>& from, std::optional<double>& into) {
    if (is_number(from)) {
      into = from;
    }
  };
  take(desired.position, prev_command.position);
  take(desired.velocity, prev_command.velocity);
  take(desired.effort, prev_command.effort);
  take(desired.acceleration, prev_command.acceleration);
  take(desired.jerk, prev_command.jerk);
  prev_command.joint_name = desired.joint_name;
}

bool is_limited(double value, double min, double max) {
  return value < min || value > max;
}

PositionLimits compute_position_limits(const std::string& joint_name, const JointLimits& limits,
                                       const std::optional<double>& act_vel,
                                       const std::optional<double>& act_pos,
                                       const std::optional<double>& prev_command_pos, double dt) {
  PositionLimits range(limits.has_position_limits ? limits.min_position : -kInfinity,
                       limits.has_position_limits ? limits.max_position : kInfinity);
  if (act_pos.has_value() && limits.has_position_limits) {
    refuse_far_outside(joint_name, *act_pos, limits);
  }
  const std::optional<double>& reference =
      prev_command_pos.has_value() ? prev_command_pos : act_pos;
  if (limits.has_velocity_limits && reference.has_value()) {
    const double reachable = limits.has_acceleration_limits
                                 ? std::fabs(act_vel.value_or(0.0)) + limits.max_acceleration * dt
                                 : limits.max_velocity;
    const double step = std::min(limits.max_velocity, reachable) * dt;
    range.lower_limit = std::max(std::min(*reference - step, range.upper_limit), range.lower_limit);
    range.upper_limit = std::min(std::max(*reference + step, range.lower_limit), range.upper_limit);
  }
  return in_order(range);
}

VelocityLimits compute_velocity_limits(const std::string& /*joint_name*/, const JointLimits& limits,
                                       const double& desired_vel,
                                       const std::optional<double>& act_pos,
                                       const std::optional<double>& prev_command_vel, double dt) {
  if (!limits.has_velocity_limits) {
    return VelocityLimits(-kInfinity, kInfinity);
  }
  VelocityLimits range(-limits.max_velocity, limits.max_velocity);
  if (limits.has_position_limits && act_pos.has_value()) {
    const double position = *act_pos;
    range.lower_limit = std::max((limits.min_position - position) / dt, range.lower_limit);
    range.upper_limit = std::min((limits.max_position - position) / dt, range.upper_limit);
    // Outside by a little, a joint may go back but no further; far outside it stands still.
    const double above = position - limits.max_position;
    const double below = limits.min_position - position;
    const double tolerance = internal::POSITION_BOUNDS_TOLERANCE;
    const bool outwards = (above > 0.0 && above < tolerance && desired_vel >= 0.0) ||
                          (below > 0.0 && below < tolerance && desired_vel <= 0.0);
    if (outwards || above > tolerance || below > tolerance) {
      range = VelocityLimits(0.0, 0.0);
    }
  }
  if (limits.has_acceleration_limits && prev_command_vel.has_value()) {
    const double step = limits.max_acceleration * dt;
    range.lower_limit = std::max(*prev_command_vel - step, range.lower_limit);
    range.upper_limit = std::min(*prev_command_vel + step, range.upper_limit);
  }
  return in_order(range);
}

EffortLimits compute_effort_limits(const JointLimits& limits, const std::optional<double>& act_pos,
                                   const std::optional<double>& act_vel, double /*dt*/) {
  if (!limits.has_effort_limits) {
    return EffortLimits(-kInfinity, kInfinity);
  }
  EffortLimits range(-limits.max_effort, limits.max_effort);
  if (limits.has_position_limits && act_pos.has_value() && act_vel.has_value()) {
    if (*act_pos <= limits.min_position && *act_vel <= 0.0) {
      range.lower_limit = 0.0;
    } else if (*act_pos >= limits.max_position && *act_vel >= 0.0) {
      range.upper_limit = 0.0;
    }
  }
  if (limits.has_velocity_limits && act_vel.has_value()) {
    if (*act_vel < -limits.max_velocity) {
      range.lower_limit = 0.0;
    } else if (*act_vel > limits.max_velocity) {
      range.upper_limit = 0.0;
    }
  }
  return in_order(range);
}

AccelerationLimits compute_acceleration_limits(const JointLimits& limits,
                                               double desired_acceleration,
                                               std::optional<double> actual_velocity) {
  const bool slows_down = desired_acceleration * actual_velocity.value_or(0.0) < 0.0;
  double largest = kInfinity;
  if (limits.has_deceleration_limits && slows_down) {
    largest = limits.max_deceleration;
  } else if (limits.has_acceleration_limits) {
    largest = limits.max_acceleration;
  }
  return in_order(AccelerationLimits(-largest, largest));
}

bool saturate(const std::string& joint_name, const JointLimits& limits,
              const JointControlInterfacesData& actual, JointControlInterfacesData& desired,
              JointControlInterfacesData& previous, double dt) {
  if (dt <= 0.0) {
    return false;
  }
  if (!previous.has_data()) {
    start_with(previous.position, actual.position, desired.position);
    start_with(previous.velocity, actual.velocity, desired.velocity);
    start_with(previous.effort, actual.effort, desired.effort);
    start_with(previous.acceleration, actual.acceleration, desired.acceleration);
    start_with(previous.jerk, actual.jerk, desired.jerk);
  }
  bool limited = false;
  const auto keep_in = [&limited](std::optional<double>& value, const detail::Range& range) {
    limited = clamp_to(value, range.lower_limit, range.upper_limit) || limited;
  };
  if (is_number(desired.position)) {
    keep_in(desired.position, compute_position_limits(joint_name, limits, actual.velocity,
                                                      actual.position, previous.position, dt));
  }
  if (is_number(desired.velocity)) {
    keep_in(desired.velocity, compute_velocity_limits(joint_name, limits, *desired.velocity,
                                                      actual.position, previous.velocity, dt));
  }
  if (is_number(desired.effort)) {
    keep_in(desired.effort, compute_effort_limits(limits, actual.position, actual.velocity, dt));
  }
  if (is_number(desired.acceleration)) {
    keep_in(desired.acceleration,
            compute_acceleration_limits(limits, *desired.acceleration, actual.velocity));
  }
  if (is_number(desired.jerk) && limits.has_jerk_limits) {
    keep_in(desired.jerk, detail::Range(-limits.max_jerk, limits.max_jerk));
  }
  update_prev_command(desired, previous);
  return limited;
}

}  // namespace joint_limits
