// Limits of joints as texts and values. This file needs no ROS.
#include "joint_limits/joint_limits.hpp"

#include <sstream>

#include "joint_limits/data_structures.hpp"

namespace joint_limits {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::max();

const char* word(bool value) {
  return value ? "true" : "false";
}

void add(std::string& text, const char* name, const std::optional<double>& value) {
  if (value.has_value()) {
    text += std::string(", ") + name + ": " + std::to_string(*value);
  }
}

}  // namespace

void JointLimits::disable_all_limits() {
  *this = JointLimits();
  min_position = -kNoLimit;
  max_position = max_velocity = max_acceleration = max_deceleration = kNoLimit;
  max_jerk = max_effort = kNoLimit;
}

std::string JointLimits::to_string() const {
  std::ostringstream text;
  text << "  has position limits: " << word(has_position_limits) << " [" << min_position << ", "
       << max_position << "]\n";
  const auto line = [&text](const char* name, bool is_set, double value) {
    text << "  has " << name << " limits: " << word(is_set) << " [" << value << "]\n";
  };
  line("velocity", has_velocity_limits, max_velocity);
  line("acceleration", has_acceleration_limits, max_acceleration);
  line("deceleration", has_deceleration_limits, max_deceleration);
  line("jerk", has_jerk_limits, max_jerk);
  line("effort", has_effort_limits, max_effort);
  text << "  angle wraparound: " << word(angle_wraparound);
  return text.str();
}

std::string SoftJointLimits::to_string() const {
  std::ostringstream text;
  text << "  soft position limits: [" << min_position << ", " << max_position << "]\n"
       << "  k-position: [" << k_position << "]\n  k-velocity: [" << k_velocity << "]\n";
  return text.str();
}

std::string JointControlInterfacesData::to_string() const {
  std::string text = "Joint: '" + joint_name + "'";
  add(text, "position", position);
  add(text, "velocity", velocity);
  add(text, "effort", effort);
  add(text, "acceleration", acceleration);
  add(text, "jerk", jerk);
  return text;
}

std::string JointInterfacesCommandLimiterData::to_string() const {
  return "Joint: '" + joint_name + "', (actual: [" + actual.to_string() + "], command: [" +
         command.to_string() + "], limited: [" + limited.to_string() + "])";
}

}  // namespace joint_limits
