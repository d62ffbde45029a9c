// Limits of a joint as its robot description gives them.
#pragma once

#include <cmath>

#include "joint_limits/joint_limits.hpp"
#include "urdf_model/joint.h"

namespace joint_limits {

/// False, with `limits` untouched, when the joint has no `<limit>`.
inline bool getJointLimits(urdf::JointConstSharedPtr urdf_joint, JointLimits& limits) {
  if (!urdf_joint || !urdf_joint->limits) {
    return false;
  }
  const auto type = urdf_joint->type;
  limits.has_position_limits = type == urdf::Joint::REVOLUTE || type == urdf::Joint::PRISMATIC;
  if (limits.has_position_limits) {
    limits.min_position = urdf_joint->limits->lower;
    limits.max_position = urdf_joint->limits->upper;
  } else if (type == urdf::Joint::CONTINUOUS) {
    limits.angle_wraparound = true;
  }
  limits.has_velocity_limits = true;
  limits.max_velocity = std::abs(urdf_joint->limits->velocity);
  limits.has_acceleration_limits = false;
  limits.has_effort_limits = true;
  limits.max_effort = std::abs(urdf_joint->limits->effort);
  return true;
}

/// False, with `soft_limits` untouched, when the joint has no `<safety_controller>`.
inline bool getSoftJointLimits(urdf::JointConstSharedPtr urdf_joint, SoftJointLimits& soft_limits) {
  if (!urdf_joint || !urdf_joint->safety) {
    return false;
  }
  soft_limits.min_position = urdf_joint->safety->soft_lower_limit;
  soft_limits.max_position = urdf_joint->safety->soft_upper_limit;
  soft_limits.k_position = urdf_joint->safety->k_position;
  soft_limits.k_velocity = urdf_joint->safety->k_velocity;
  return true;
}

}  // namespace joint_limits
