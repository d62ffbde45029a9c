// Limits of one joint, as its description or parameters give them.
#pragma once

#include <limits>
#include <string>

namespace joint_limits {

/// A value counts only when its `has_` flag is set. Units are those of the joint: rad or m.
struct JointLimits {
  double min_position = std::numeric_limits<double>::quiet_NaN();
  double max_position = std::numeric_limits<double>::quiet_NaN();
  double max_velocity = std::numeric_limits<double>::quiet_NaN();
  double max_acceleration = std::numeric_limits<double>::quiet_NaN();
  double max_deceleration = std::numeric_limits<double>::quiet_NaN();
  double max_jerk = std::numeric_limits<double>::quiet_NaN();
  double max_effort = std::numeric_limits<double>::quiet_NaN();

  bool has_position_limits = false;
  bool has_velocity_limits = false;
  bool has_acceleration_limits = false;
  bool has_deceleration_limits = false;
  bool has_jerk_limits = false;
  bool has_effort_limits = false;
  bool angle_wraparound = false;

  void disable_all_limits();
  std::string to_string() const;
};

/// Limits of a `<safety_controller>`: velocity is reduced before the position limit is reached.
struct SoftJointLimits {
  double min_position = std::numeric_limits<double>::quiet_NaN();
  double max_position = std::numeric_limits<double>::quiet_NaN();
  double k_position = std::numeric_limits<double>::quiet_NaN();
  double k_velocity = std::numeric_limits<double>::quiet_NaN();

  std::string to_string() const;
};

}  // namespace joint_limits
