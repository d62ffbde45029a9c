// A controller that tries many velocities in each cycle: a generator says where each takes the
// robot, critics score that, and the velocity with the least total becomes the command.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dwb_core/publisher.hpp"
#include "dwb_core/trajectory_critic.hpp"
#include "dwb_core/trajectory_generator.hpp"
#include "dwb_msgs/msg/trajectory_score.hpp"
#include "nav2_core/controller.hpp"
#include "nav2_core/goal_checker.hpp"
#include "nav_2d_msgs/msg/pose2_d_stamped.hpp"
#include "nav_2d_msgs/msg/twist2_d_stamped.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"

namespace dwb_core {

class DWBLocalPlanner : public nav2_core::Controller {
 public:
  DWBLocalPlanner();
  virtual ~DWBLocalPlanner() {}

  void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
                 std::shared_ptr<tf2_ros::Buffer> tf,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override;
  void activate() override;
  void deactivate() override;
  void cleanup() override;
  /// Throws nav2_core::InvalidPath for places that are not finite.
  void setPlan(const nav_msgs::msg::Path& path) override;
  geometry_msgs::msg::TwistStamped computeVelocityCommands(
      const geometry_msgs::msg::PoseStamped& pose, const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* /*goal_checker*/) override;

  /// Sums up the critics; stops once the sum is above `best_score`, when that is above 0.
  virtual dwb_msgs::msg::TrajectoryScore scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj,
                                                         double best_score = -1);
  /// Fills `results` unless it is null.
  virtual nav_2d_msgs::msg::Twist2DStamped computeVelocityCommands(
      const nav_2d_msgs::msg::Pose2DStamped& pose, const nav_2d_msgs::msg::Twist2D& velocity,
      std::shared_ptr<dwb_msgs::msg::LocalPlanEvaluation>& results);
  void setSpeedLimit(const double& speed_limit, const bool& percentage) override {
    if (traj_generator_) traj_generator_->setSpeedLimit(speed_limit, percentage);
  }

 protected:
  void prepareGlobalPlan(const nav_2d_msgs::msg::Pose2DStamped& pose,
                         nav_2d_msgs::msg::Path2D& transformed_plan,
                         nav_2d_msgs::msg::Pose2DStamped& goal_pose, bool publish_plan = true);
  /// Throws NoLegalTrajectoriesException.
  virtual dwb_msgs::msg::TrajectoryScore coreScoringAlgorithm(
      const geometry_msgs::msg::Pose2D& pose, const nav_2d_msgs::msg::Twist2D velocity,
      std::shared_ptr<dwb_msgs::msg::LocalPlanEvaluation>& results);
  /// The part of the path near the robot, in the frame of the local costmap. With `prune_plan`, the
  /// part behind the robot is dropped for good.
  virtual nav_2d_msgs::msg::Path2D transformGlobalPlan(const nav_2d_msgs::msg::Pose2DStamped& pose);
  /// With `Critic` at the end, and a default namespace in front when it has none.
  std::string resolveCriticClassName(std::string base_name);
  virtual void loadCritics();

  nav_2d_msgs::msg::Path2D global_plan_;
  bool prune_plan_ = true;
  double prune_distance_ = 2.0;
  bool debug_trajectory_details_ = false;
  rclcpp::Duration transform_tolerance_{0, 0};
  bool shorten_transformed_plan_ = true;
  double forward_prune_distance_ = 2.0;

  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("DWBLocalPlanner")};
  std::shared_ptr<tf2_ros::Buffer> tf_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros_;
  std::unique_ptr<DWBPublisher> pub_;
  std::vector<std::string> default_critic_namespaces_;

  // Loaders come before what they load.
  pluginlib::ClassLoader<TrajectoryGenerator> traj_gen_loader_;
  TrajectoryGenerator::Ptr traj_generator_;
  pluginlib::ClassLoader<TrajectoryCritic> critic_loader_;
  std::vector<TrajectoryCritic::Ptr> critics_;
  std::string dwb_plugin_name_;
  bool short_circuit_trajectory_evaluation_ = true;

 private:
  void readParameters(std::string& generator);
  void loadCritic(const nav2_util::LifecycleNode::SharedPtr& node, const std::string& name);
  void conclude(const nav_2d_msgs::msg::Pose2DStamped& pose,
                const dwb_msgs::msg::Trajectory2D& chosen);
  geometry_msgs::msg::TransformStamped planToCostmap() const;
};

}  // namespace dwb_core
