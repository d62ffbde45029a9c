// See trajectory_checks.hpp.
#include "joint_trajectory_controller/trajectory_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace joint_trajectory_controller {
namespace {

double seconds(int64_t ns) {
  return static_cast<double>(ns) * 1e-9;
}

std::string why_names_refused(const PathRequest& request, const TrajectoryRules& rules) {
  if (!rules.allows_partial_joints && request.joints.size() != rules.joints.size()) {
    return "Joints on incoming trajectory don't match the controller joints.";
  }
  if (request.joints.empty()) return "Empty joint names on incoming trajectory.";
  if (request.points.empty()) return "Empty trajectory received.";
  for (const std::string& name : request.joints) {
    if (std::find(rules.joints.begin(), rules.joints.end(), name) == rules.joints.end()) {
      return "Incoming joint " + name + " doesn't match the controller's joints.";
    }
  }
  std::vector<std::string> sorted = request.joints;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  return twice == sorted.end() ? "" : "Incoming joint " + *twice + " is named more than once.";
}

std::string why_end_refused(const PathRequest& request, const TrajectoryRules& rules) {
  const PathPoint& last = request.points.back();
  char text[160];
  if (!rules.allows_nonzero_end_velocity) {
    for (size_t i = 0; i < last.velocities.size() && i < request.joints.size(); ++i) {
      if (std::abs(last.velocities[i]) <= std::numeric_limits<float>::epsilon()) continue;
      std::snprintf(text, sizeof text, " is not zero: %.15f", last.velocities[i]);
      return "Velocity of last trajectory point of joint " + request.joints[i] + text;
    }
  }
  const int64_t end_ns = request.start_ns + last.from_start_ns;
  if (request.start_ns != 0 && end_ns < rules.now_ns) {
    std::snprintf(text, sizeof text,
                  "Received trajectory with non-zero start time (%f) that ends in the past (%f)",
                  seconds(request.start_ns), seconds(end_ns));
    return text;
  }
  return "";
}

std::string why_field_refused(const std::vector<double>& values, const char* field, size_t joints,
                              size_t point, bool may_be_empty) {
  if ((may_be_empty && values.empty()) || values.size() == joints) return "";
  return "Mismatch between joint_names size (" + std::to_string(joints) + ") and " + field + " (" +
         std::to_string(values.size()) + ") at point #" + std::to_string(point) + ".";
}

std::string why_point_refused(const PathRequest& request, size_t i, const TrajectoryRules& rules) {
  const PathPoint& point = request.points[i];
  if (i > 0 && point.from_start_ns <= request.points[i - 1].from_start_ns) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "Time between points %zu and %zu is not strictly increasing, it is %f and %f "
                  "respectively",
                  i - 1, i, seconds(request.points[i - 1].from_start_ns),
                  seconds(point.from_start_ns));
    return text;
  }
  if (rules.allows_integration && point.positions.empty() && point.velocities.empty() &&
      point.accelerations.empty()) {
    return "The given trajectory has no position, velocity, or acceleration points.";
  }
  const size_t joints = request.joints.size();
  std::string why =
      why_field_refused(point.positions, "positions", joints, i, rules.allows_integration);
  if (why.empty()) why = why_field_refused(point.velocities, "velocities", joints, i, true);
  if (why.empty()) why = why_field_refused(point.accelerations, "accelerations", joints, i, true);
  if (!why.empty()) return why;
  if (!rules.has_effort_command && !point.effort.empty()) {
    return "Trajectories with effort fields are only supported for controllers using the 'effort' "
           "command interface.";
  }
  return why_field_refused(point.effort, "effort", joints, i, true);
}

}  // namespace

std::string why_refused(const PathRequest& request, const TrajectoryRules& rules) {
  std::string why = why_names_refused(request, rules);
  if (why.empty()) why = why_end_refused(request, rules);
  for (size_t i = 0; why.empty() && i < request.points.size(); ++i) {
    why = why_point_refused(request, i, rules);
  }
  return why;
}

}  // namespace joint_trajectory_controller
