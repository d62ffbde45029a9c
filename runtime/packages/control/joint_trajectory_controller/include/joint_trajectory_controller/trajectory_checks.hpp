// Whether a trajectory can be run. Knows nothing of ROS.
#pragma once

#include <string>
#include <vector>

#include "joint_trajectory_controller/spline.hpp"

namespace joint_trajectory_controller {

struct TrajectoryRules {
  std::vector<std::string> joints;  ///< of the controller
  bool allows_partial_joints = false;
  bool allows_nonzero_end_velocity = false;
  bool allows_integration = false;  ///< of points without positions
  bool has_effort_command = false;
  int64_t now_ns = 0;
};

/// The reason why a trajectory is refused, or an empty text.
std::string why_refused(const PathRequest& request, const TrajectoryRules& rules);

}  // namespace joint_trajectory_controller
