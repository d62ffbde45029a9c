// How far joints may be from what is wanted. Knows nothing of ROS.
#pragma once

#include <string>
#include <vector>

#include "joint_trajectory_controller/spline.hpp"

namespace joint_trajectory_controller {

/// The tolerances of one joint; 0: not checked.
struct StateTolerances {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
};

struct SegmentTolerances {
  explicit SegmentTolerances(size_t size = 0) : state_tolerance(size), goal_state_tolerance(size) {}

  std::vector<StateTolerances> state_tolerance;       ///< on the way
  std::vector<StateTolerances> goal_state_tolerance;  ///< at the end
  double goal_time_tolerance = 0.0;                   ///< [s] after the end; 0: no limit
};

/// The tolerances that a goal wants for a joint: 0 keeps the default, -1 means no limit, more than
/// 0 replaces it.
struct JointTolerance {
  std::string name;
  StateTolerances wanted;
};

struct GoalTolerances {
  std::vector<JointTolerance> path;
  std::vector<JointTolerance> goal;
  double goal_time_s = 0.0;
};

/// The defaults with what the goal wants; the defaults alone, with a text, when it is illegal.
SegmentTolerances segment_tolerances(const SegmentTolerances& defaults, const GoalTolerances& goal,
                                     const std::vector<std::string>& joints, std::string& problem);

/// Whether the error of a joint is within its tolerances.
bool is_within(const PathPoint& error, size_t joint, const StateTolerances& tolerances);
/// Lines that say what of it is not.
std::vector<std::string> explain(const PathPoint& error, size_t joint,
                                 const StateTolerances& tolerances);

}  // namespace joint_trajectory_controller
