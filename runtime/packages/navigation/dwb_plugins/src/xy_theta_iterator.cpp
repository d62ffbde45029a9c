// See xy_theta_iterator.hpp.
#include "dwb_plugins/xy_theta_iterator.hpp"

#include "nav2_util/node_utils.hpp"

namespace dwb_plugins {

void XYThetaIterator::initialize(const nav2_util::LifecycleNode::SharedPtr& nh,
                                 KinematicsHandler::Ptr kinematics,
                                 const std::string& plugin_name) {
  kinematics_handler_ = kinematics;
  const auto read = [&](const char* name, int& value) {
    const std::string full = plugin_name + "." + name;
    nav2_util::declare_parameter_if_not_declared(nh, full, rclcpp::ParameterValue(value));
    nh->get_parameter(full, value);
  };
  read("vx_samples", vx_samples_);
  read("vy_samples", vy_samples_);
  read("vtheta_samples", vtheta_samples_);
}

void XYThetaIterator::startNewIteration(const nav_2d_msgs::msg::Twist2D& current_velocity,
                                        double dt) {
  KinematicParameters limits = kinematics_handler_->getKinematics();
  x_it_ =
      std::make_shared<OneDVelocityIterator>(current_velocity.x, limits.getMinX(), limits.getMaxX(),
                                             limits.getAccX(), limits.getDecelX(), dt, vx_samples_);
  y_it_ =
      std::make_shared<OneDVelocityIterator>(current_velocity.y, limits.getMinY(), limits.getMaxY(),
                                             limits.getAccY(), limits.getDecelY(), dt, vy_samples_);
  th_it_ = std::make_shared<OneDVelocityIterator>(current_velocity.theta, limits.getMinTheta(),
                                                  limits.getMaxTheta(), limits.getAccTheta(),
                                                  limits.getDecelTheta(), dt, vtheta_samples_);
  if (!isValidVelocity()) iterateToValidVelocity();
  if (hasMoreTwists()) return;
  RCLCPP_ERROR(
      rclcpp::get_logger("DWBLocalPlanner"),
      "No velocity is within the limits: x from %g to %g m/s, y from %g to %g m/s, theta from %g "
      "to %g rad/s, speed from %g to %g m/s. Look at max_speed_xy and max_vel_*; acc_lim_* must be "
      "positive, and decel_lim_* negative.",
      limits.getMinX(), limits.getMaxX(), limits.getMinY(), limits.getMaxY(), limits.getMinTheta(),
      limits.getMaxTheta(), limits.getMinSpeedXY(), limits.getMaxSpeedXY());
}

bool XYThetaIterator::isValidVelocity() {
  return kinematics_handler_->getKinematics().isValidSpeed(
      x_it_->getVelocity(), y_it_->getVelocity(), th_it_->getVelocity());
}

bool XYThetaIterator::hasMoreTwists() {
  return x_it_ && !x_it_->isFinished();
}

nav_2d_msgs::msg::Twist2D XYThetaIterator::nextTwist() {
  nav_2d_msgs::msg::Twist2D velocity;
  velocity.x = x_it_->getVelocity();
  velocity.y = y_it_->getVelocity();
  velocity.theta = th_it_->getVelocity();
  iterateToValidVelocity();
  return velocity;
}

void XYThetaIterator::iterateToValidVelocity() {
  do {
    ++*th_it_;
    if (!th_it_->isFinished()) continue;
    th_it_->reset();
    ++*y_it_;
    if (!y_it_->isFinished()) continue;
    y_it_->reset();
    ++*x_it_;
  } while (hasMoreTwists() && !isValidVelocity());
}

}  // namespace dwb_plugins
