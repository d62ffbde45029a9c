// Velocities that the robot can reach within the simulated time, and the poses on the way.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dwb_core/trajectory_generator.hpp"
#include "dwb_plugins/kinematic_parameters.hpp"
#include "dwb_plugins/velocity_iterator.hpp"
#include "nav2_util/lifecycle_node.hpp"

namespace dwb_plugins {

class StandardTrajectoryGenerator : public dwb_core::TrajectoryGenerator {
 public:
  /// Throws std::runtime_error for times and distances that are not above 0.
  void initialize(const nav2_util::LifecycleNode::SharedPtr& nh,
                  const std::string& plugin_name) override;
  void startNewIteration(const nav_2d_msgs::msg::Twist2D& current_velocity) override;
  bool hasMoreTwists() override;
  nav_2d_msgs::msg::Twist2D nextTwist() override;
  /// Begins with the start; the last pose is there twice with `include_last_point`.
  dwb_msgs::msg::Trajectory2D generateTrajectory(const geometry_msgs::msg::Pose2D& start_pose,
                                                 const nav_2d_msgs::msg::Twist2D& start_vel,
                                                 const nav_2d_msgs::msg::Twist2D& cmd_vel) override;
  void setSpeedLimit(const double& speed_limit, const bool& percentage) override {
    if (kinematics_handler_) kinematics_handler_->setSpeedLimit(speed_limit, percentage);
  }

 protected:
  /// Throws std::runtime_error unless the value of a parameter is finite and above 0.
  static void check_positive(const std::string& name, double value);
  virtual void initializeIterator(const nav2_util::LifecycleNode::SharedPtr& nh);
  /// After `dt` seconds on the way from one velocity to the command.
  virtual nav_2d_msgs::msg::Twist2D computeNewVelocity(const nav_2d_msgs::msg::Twist2D& cmd_vel,
                                                       const nav_2d_msgs::msg::Twist2D& start_vel,
                                                       const double dt);
  virtual geometry_msgs::msg::Pose2D computeNewPosition(const geometry_msgs::msg::Pose2D start_pose,
                                                        const nav_2d_msgs::msg::Twist2D& vel,
                                                        const double dt);
  /// The lengths of the steps [s].
  virtual std::vector<double> getTimeSteps(const nav_2d_msgs::msg::Twist2D& cmd_vel);

  KinematicsHandler::Ptr kinematics_handler_;
  std::shared_ptr<VelocityIterator> velocity_iterator_;
  double sim_time_ = 1.7;  // s
  bool discretize_by_time_ = false;
  double time_granularity_ = 0.5;  // s between poses
  // Between poses otherwise, in m and rad.
  double linear_granularity_ = 0.5;
  double angular_granularity_ = 0.025;
  std::string plugin_name_;
  /// The command is the velocity after the first step.
  bool limit_vel_cmd_in_traj_ = false;
  bool include_last_point_ = true;
};

}  // namespace dwb_plugins
