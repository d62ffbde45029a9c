// Where the world frame of a robot is in flat coordinates of the globe. Without ROS.
#pragma once

#include <Eigen/Geometry>

#include "filter/state.hpp"

namespace robot_localization {

/// From one place of the robot, known in both frames, and its heading in the flat one [rad].
inline Eigen::Isometry3d world_from_cartesian(const Eigen::Isometry3d& robot_in_world,
                                              const Eigen::Vector3d& robot_in_cartesian,
                                              double heading) {
  Eigen::Isometry3d world = robot_in_world;
  world.linear() = only_yaw(robot_in_world.linear());
  Eigen::Isometry3d cartesian = Eigen::Isometry3d::Identity();
  cartesian.translation() = robot_in_cartesian;
  cartesian.linear() = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return world * cartesian.inverse();
}

}  // namespace robot_localization
