// See limited_accel_generator.hpp.
#include "dwb_plugins/limited_accel_generator.hpp"

#include "nav2_util/node_utils.hpp"
#include "nav_2d_utils/parameters.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_plugins {

using nav_2d_msgs::msg::Twist2D;

void LimitedAccelGenerator::initialize(const nav2_util::LifecycleNode::SharedPtr& nh,
                                       const std::string& plugin_name) {
  plugin_name_ = plugin_name;
  StandardTrajectoryGenerator::initialize(nh, plugin_name);
  const std::string name = plugin_name + ".sim_period";
  nav2_util::declare_parameter_if_not_declared(nh, name, rclcpp::PARAMETER_DOUBLE);
  if (nh->get_parameter(name, acceleration_time_)) {
    check_positive(name, acceleration_time_);
    return;
  }
  const rclcpp::Logger logger = rclcpp::get_logger("LimitedAccelGenerator");
  RCLCPP_WARN(logger, "'sim_period' parameter is not set for %s", plugin_name.c_str());
  const double frequency = nav_2d_utils::searchAndGetParam(nh, "controller_frequency", 20.0);
  if (frequency > 0) {
    acceleration_time_ = 1.0 / frequency;
    return;
  }
  RCLCPP_WARN(logger,
              "A controller_frequency less than or equal to 0 has been set. Ignoring the "
              "parameter, assuming a rate of 20Hz");
  acceleration_time_ = 0.05;
}

void LimitedAccelGenerator::startNewIteration(const Twist2D& current_velocity) {
  velocity_iterator_->startNewIteration(current_velocity, acceleration_time_);
}

Twist2D LimitedAccelGenerator::computeNewVelocity(const Twist2D& cmd_vel,
                                                  const Twist2D& /*start_vel*/,
                                                  const double /*dt*/) {
  return cmd_vel;
}

}  // namespace dwb_plugins

PLUGINLIB_EXPORT_CLASS(dwb_plugins::LimitedAccelGenerator, dwb_core::TrajectoryGenerator)
