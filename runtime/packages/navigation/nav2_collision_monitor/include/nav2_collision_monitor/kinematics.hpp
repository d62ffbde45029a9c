// How a robot moves, and where things are then.
#pragma once

#include <vector>

#include "nav2_collision_monitor/types.hpp"

namespace nav2_collision_monitor {

/// Into the frame that has this pose.
void transformPoints(const Pose& pose, std::vector<Point>& points);
/// Moves the pose by `dt` seconds. The velocity turns with the robot.
void projectState(const double& dt, Pose& pose, Velocity& velocity);

}  // namespace nav2_collision_monitor
