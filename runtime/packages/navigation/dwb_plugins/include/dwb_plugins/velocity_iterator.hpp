// The base of classes that go through the velocities that a robot can reach.
#pragma once

#include <memory>
#include <string>

#include "dwb_plugins/kinematic_parameters.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav_2d_msgs/msg/twist2_d.hpp"
#include "rclcpp/rclcpp.hpp"

namespace dwb_plugins {

class VelocityIterator {
 public:
  virtual ~VelocityIterator() {}
  virtual void initialize(const nav2_util::LifecycleNode::SharedPtr& nh,
                          KinematicsHandler::Ptr kinematics, const std::string& plugin_name) = 0;
  /// Velocities that can be reached within `dt` seconds.
  virtual void startNewIteration(const nav_2d_msgs::msg::Twist2D& current_velocity, double dt) = 0;
  virtual bool hasMoreTwists() = 0;
  virtual nav_2d_msgs::msg::Twist2D nextTwist() = 0;
};

}  // namespace dwb_plugins
