// See tolerances.hpp.
#include "joint_trajectory_controller/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace joint_trajectory_controller {
namespace {

/// False for a value that means nothing.
bool resolve(double& tolerance, double wanted) {
  if (wanted > 0.0) {
    tolerance = wanted;
  } else if (std::abs(wanted + 1.0) < std::numeric_limits<float>::epsilon()) {
    tolerance = 0.0;
  } else if (wanted < 0.0) {
    return false;
  }
  return true;
}

/// A text when one of them is illegal.
std::string resolve_all(std::vector<StateTolerances>& tolerances,
                        const std::vector<JointTolerance>& wanted,
                        const std::vector<std::string>& joints, const std::string& field) {
  for (const JointTolerance& one : wanted) {
    const auto found = std::find(joints.begin(), joints.end(), one.name);
    if (found == joints.end()) {
      return "joint '" + one.name + "' specified in " + field +
             " does not exist. Using default tolerances.";
    }
    StateTolerances& of_joint = tolerances[static_cast<size_t>(found - joints.begin())];
    const char* illegal = nullptr;
    if (!resolve(of_joint.acceleration, one.wanted.acceleration)) illegal = "acceleration";
    if (!resolve(of_joint.velocity, one.wanted.velocity)) illegal = "velocity";
    if (!resolve(of_joint.position, one.wanted.position)) illegal = "position";
    if (illegal != nullptr) {
      return "joint '" + one.name + "' specified in " + field + " has a invalid " + illegal +
             " tolerance. Using default tolerances.";
    }
  }
  return "";
}

struct Checked {
  const char* name;
  double error;
  double tolerance;

  [[nodiscard]] bool is_within() const { return !(tolerance > 0.0 && std::abs(error) > tolerance); }
};

double value_of(const std::vector<double>& values, size_t joint) {
  return values.empty() ? 0.0 : values[joint];
}

std::array<Checked, 3> checked(const PathPoint& error, size_t joint,
                               const StateTolerances& tolerances) {
  return {Checked{"Position", error.positions[joint], tolerances.position},
          Checked{"Velocity", value_of(error.velocities, joint), tolerances.velocity},
          Checked{"Acceleration", value_of(error.accelerations, joint), tolerances.acceleration}};
}

}  // namespace

SegmentTolerances segment_tolerances(const SegmentTolerances& defaults, const GoalTolerances& goal,
                                     const std::vector<std::string>& joints, std::string& problem) {
  SegmentTolerances tolerances = defaults;
  if (!resolve(tolerances.goal_time_tolerance, goal.goal_time_s)) {
    problem = "Specified illegal goal_time_tolerance: " + std::to_string(goal.goal_time_s) +
              ". Using default tolerances";
    return defaults;
  }
  problem = resolve_all(tolerances.state_tolerance, goal.path, joints, "goal.path_tolerance");
  if (problem.empty()) {
    problem =
        resolve_all(tolerances.goal_state_tolerance, goal.goal, joints, "goal.goal_tolerance");
  }
  return problem.empty() ? tolerances : defaults;
}

bool is_within(const PathPoint& error, size_t joint, const StateTolerances& tolerances) {
  const auto all = checked(error, joint, tolerances);
  return std::all_of(all.begin(), all.end(), [](const Checked& one) { return one.is_within(); });
}

std::vector<std::string> explain(const PathPoint& error, size_t joint,
                                 const StateTolerances& tolerances) {
  std::vector<std::string> lines = {"State tolerances failed for joint " + std::to_string(joint) +
                                    ":"};
  for (const Checked& one : checked(error, joint, tolerances)) {
    if (one.is_within()) continue;
    lines.push_back(std::string(one.name) + " Error: " + std::to_string(one.error) + ", " +
                    one.name + " Tolerance: " + std::to_string(one.tolerance));
  }
  return lines;
}

}  // namespace joint_trajectory_controller
