// A point ahead of the robot.
#pragma once

#include "geometry_msgs/msg/pose2_d.hpp"

namespace dwb_critics {

/// The same direction, `distance` metres ahead.
geometry_msgs::msg::Pose2D getForwardPose(const geometry_msgs::msg::Pose2D& pose, double distance);

}  // namespace dwb_critics
