// Values of a joint that limiters work on, and the ranges they compute.
#pragma once

#include <limits>
#include <optional>
#include <string>

namespace joint_limits {

namespace detail {
struct Range {
  Range(double minimum_value, double maximum_value)
      : lower_limit(minimum_value), upper_limit(maximum_value) {}
  double lower_limit = -std::numeric_limits<double>::infinity();
  double upper_limit = std::numeric_limits<double>::infinity();
};
}  // namespace detail

struct PositionLimits : detail::Range {
  using Range::Range;
};
struct VelocityLimits : detail::Range {
  using Range::Range;
};
struct EffortLimits : detail::Range {
  using Range::Range;
};
struct AccelerationLimits : detail::Range {
  using Range::Range;
};

struct JointControlInterfacesData {
  std::string joint_name;
  std::optional<double> position = std::nullopt;
  std::optional<double> velocity = std::nullopt;
  std::optional<double> effort = std::nullopt;
  std::optional<double> acceleration = std::nullopt;
  std::optional<double> jerk = std::nullopt;

  bool has_data() const {
    return has_position() || has_velocity() || has_effort() || has_acceleration() || has_jerk();
  }
  bool has_position() const { return position.has_value(); }
  bool has_velocity() const { return velocity.has_value(); }
  bool has_effort() const { return effort.has_value(); }
  bool has_acceleration() const { return acceleration.has_value(); }
  bool has_jerk() const { return jerk.has_value(); }
  std::string to_string() const;
};

struct JointInterfacesCommandLimiterData {
  std::string joint_name;
  JointControlInterfacesData actual;
  JointControlInterfacesData command;
  JointControlInterfacesData prev_command;
  JointControlInterfacesData limited;

  bool has_actual_data() const { return actual.has_data(); }
  bool has_command_data() const { return command.has_data(); }
  bool has_limited_data() const { return limited.has_data(); }
  void set_joint_name(const std::string& name) {
    joint_name = actual.joint_name = command.joint_name = name;
    limited.joint_name = prev_command.joint_name = name;
  }
  std::string to_string() const;
};

}  // namespace joint_limits
