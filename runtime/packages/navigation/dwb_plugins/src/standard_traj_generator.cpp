// See standard_traj_generator.hpp.
#include "dwb_plugins/standard_traj_generator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dwb_plugins/motion_steps.hpp"
#include "dwb_plugins/one_d_velocity_iterator.hpp"
#include "dwb_plugins/xy_theta_iterator.hpp"
#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_plugins {

using geometry_msgs::msg::Pose2D;
using nav_2d_msgs::msg::Twist2D;

namespace {

builtin_interfaces::msg::Duration duration_of(double seconds) {
  builtin_interfaces::msg::Duration result;
  result.sec = static_cast<int32_t>(seconds);
  result.nanosec = static_cast<uint32_t>((seconds - result.sec) * 1e9);
  return result;
}

}  // namespace

void StandardTrajectoryGenerator::check_positive(const std::string& name, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw std::runtime_error(name + " must be finite and greater than 0");
}

void StandardTrajectoryGenerator::initialize(const nav2_util::LifecycleNode::SharedPtr& nh,
                                             const std::string& plugin_name) {
  plugin_name_ = plugin_name;
  kinematics_handler_ = std::make_shared<KinematicsHandler>();
  kinematics_handler_->initialize(nh, plugin_name_);
  initializeIterator(nh);
  const auto read = [&](const char* name, auto& value) {
    const std::string full = plugin_name + "." + name;
    nav2_util::declare_parameter_if_not_declared(nh, full, rclcpp::ParameterValue(value));
    nh->get_parameter(full, value);
  };
  read("sim_time", sim_time_);
  read("discretize_by_time", discretize_by_time_);
  read("time_granularity", time_granularity_);
  read("linear_granularity", linear_granularity_);
  read("angular_granularity", angular_granularity_);
  read("include_last_point", include_last_point_);
  read("limit_vel_cmd_in_traj", limit_vel_cmd_in_traj_);
  const auto check = [&](const char* name, double value) {
    check_positive(plugin_name + "." + name, value);
  };
  check("sim_time", sim_time_);
  if (discretize_by_time_) {
    check("time_granularity", time_granularity_);
  } else {
    check("linear_granularity", linear_granularity_);
    check("angular_granularity", angular_granularity_);
  }
}

void StandardTrajectoryGenerator::initializeIterator(
    const nav2_util::LifecycleNode::SharedPtr& nh) {
  velocity_iterator_ = std::make_shared<XYThetaIterator>();
  velocity_iterator_->initialize(nh, kinematics_handler_, plugin_name_);
}

void StandardTrajectoryGenerator::startNewIteration(const Twist2D& current_velocity) {
  velocity_iterator_->startNewIteration(current_velocity, sim_time_);
}

bool StandardTrajectoryGenerator::hasMoreTwists() {
  return velocity_iterator_->hasMoreTwists();
}

Twist2D StandardTrajectoryGenerator::nextTwist() {
  return velocity_iterator_->nextTwist();
}

std::vector<double> StandardTrajectoryGenerator::getTimeSteps(const Twist2D& cmd_vel) {
  size_t count = count_steps(cmd_vel, sim_time_, linear_granularity_, angular_granularity_);
  if (discretize_by_time_) {
    count =
        static_cast<size_t>(std::min(std::ceil(sim_time_ / time_granularity_), double{kMostSteps}));
  }
  return std::vector<double>(count, sim_time_ / static_cast<double>(count));
}

dwb_msgs::msg::Trajectory2D StandardTrajectoryGenerator::generateTrajectory(
    const Pose2D& start_pose, const Twist2D& start_vel, const Twist2D& cmd_vel) {
  const std::vector<double> steps = getTimeSteps(cmd_vel);
  dwb_msgs::msg::Trajectory2D result;
  result.velocity = cmd_vel;
  result.poses.reserve(steps.size() + 2);
  result.time_offsets.reserve(steps.size() + 1);
  result.poses.push_back(start_pose);
  Pose2D pose = start_pose;
  Twist2D velocity = start_vel;
  double time = 0.0;
  for (const double dt : steps) {
    velocity = computeNewVelocity(cmd_vel, velocity, dt);
    if (limit_vel_cmd_in_traj_ && result.poses.size() == 1) result.velocity = velocity;
    pose = computeNewPosition(pose, velocity, dt);
    result.poses.push_back(pose);
    result.time_offsets.push_back(duration_of(time));
    time += dt;
  }
  if (include_last_point_) {
    result.poses.push_back(pose);
    result.time_offsets.push_back(duration_of(time));
  }
  return result;
}

Twist2D StandardTrajectoryGenerator::computeNewVelocity(const Twist2D& cmd_vel,
                                                        const Twist2D& start_vel, const double dt) {
  KinematicParameters limits = kinematics_handler_->getKinematics();
  Twist2D result;
  result.x = projectVelocity(start_vel.x, limits.getAccX(), limits.getDecelX(), dt, cmd_vel.x);
  result.y = projectVelocity(start_vel.y, limits.getAccY(), limits.getDecelY(), dt, cmd_vel.y);
  result.theta = projectVelocity(start_vel.theta, limits.getAccTheta(), limits.getDecelTheta(), dt,
                                 cmd_vel.theta);
  return result;
}

Pose2D StandardTrajectoryGenerator::computeNewPosition(const Pose2D start_pose, const Twist2D& vel,
                                                       const double dt) {
  return moved(start_pose, vel, dt);
}

}  // namespace dwb_plugins

PLUGINLIB_EXPORT_CLASS(dwb_plugins::StandardTrajectoryGenerator, dwb_core::TrajectoryGenerator)
