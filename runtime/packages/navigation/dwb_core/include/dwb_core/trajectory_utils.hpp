// The place of a robot on a trajectory at a time [s] since its start. Both functions throw
// nav2_core::InvalidPath for a trajectory without poses.
#pragma once

#include "dwb_msgs/msg/trajectory2_d.hpp"
#include "geometry_msgs/msg/pose2_d.hpp"

namespace dwb_core {

/// The pose whose time is nearest.
const geometry_msgs::msg::Pose2D& getClosestPose(const dwb_msgs::msg::Trajectory2D& trajectory,
                                                 const double time_offset);
/// Between the two poses around that time.
geometry_msgs::msg::Pose2D projectPose(const dwb_msgs::msg::Trajectory2D& trajectory,
                                       const double time_offset);

}  // namespace dwb_core
