// All combinations of velocities along x and y, and about z, that the limits of the robot allow.
#pragma once

#include <memory>
#include <string>

#include "dwb_plugins/one_d_velocity_iterator.hpp"
#include "dwb_plugins/velocity_iterator.hpp"
#include "nav2_util/lifecycle_node.hpp"

namespace dwb_plugins {

class XYThetaIterator : public VelocityIterator {
 public:
  void initialize(const nav2_util::LifecycleNode::SharedPtr& nh, KinematicsHandler::Ptr kinematics,
                  const std::string& plugin_name) override;
  void startNewIteration(const nav_2d_msgs::msg::Twist2D& current_velocity, double dt) override;
  bool hasMoreTwists() override;
  nav_2d_msgs::msg::Twist2D nextTwist() override;

 protected:
  virtual bool isValidVelocity();
  void iterateToValidVelocity();

  int vx_samples_ = 20;
  int vy_samples_ = 5;
  int vtheta_samples_ = 20;
  KinematicsHandler::Ptr kinematics_handler_;
  std::shared_ptr<OneDVelocityIterator> x_it_;
  std::shared_ptr<OneDVelocityIterator> y_it_;
  std::shared_ptr<OneDVelocityIterator> th_it_;
};

}  // namespace dwb_plugins
