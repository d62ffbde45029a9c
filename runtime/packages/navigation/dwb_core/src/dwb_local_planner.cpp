// See dwb_local_planner.hpp. Scores are in evaluation.cpp, the path is in plan_near_robot.cpp.
#include "dwb_core/dwb_local_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dwb_core/illegal_trajectory_tracker.hpp"
#include "nav2_core/controller_exceptions.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav_2d_utils/conversions.hpp"

namespace dwb_core {

using dwb_msgs::msg::LocalPlanEvaluation;
using dwb_msgs::msg::Trajectory2D;
using nav2_util::declare_parameter_if_not_declared;
using nav_2d_msgs::msg::Pose2DStamped;
using nav_2d_msgs::msg::Twist2D;
using nav_2d_msgs::msg::Twist2DStamped;

DWBLocalPlanner::DWBLocalPlanner()
    : traj_gen_loader_("dwb_core", "dwb_core::TrajectoryGenerator"),
      critic_loader_("dwb_core", "dwb_core::TrajectoryCritic") {}

void DWBLocalPlanner::readParameters(std::string& generator) {
  const auto node = node_.lock();
  const auto read = [&](const char* name, auto& value) {
    const std::string full = dwb_plugin_name_ + "." + name;
    declare_parameter_if_not_declared(node, full, rclcpp::ParameterValue(value));
    node->get_parameter(full, value);
  };
  declare_parameter_if_not_declared(node, dwb_plugin_name_ + ".critics",
                                    rclcpp::PARAMETER_STRING_ARRAY);
  double transform_tolerance = 0.1;
  default_critic_namespaces_.clear();
  read("default_critic_namespaces", default_critic_namespaces_);
  read("prune_plan", prune_plan_);
  read("prune_distance", prune_distance_);
  read("forward_prune_distance", forward_prune_distance_);
  read("debug_trajectory_details", debug_trajectory_details_);
  read("trajectory_generator_name", generator);
  read("transform_tolerance", transform_tolerance);
  read("shorten_transformed_plan", shorten_transformed_plan_);
  read("short_circuit_trajectory_evaluation", short_circuit_trajectory_evaluation_);
  transform_tolerance_ = rclcpp::Duration::from_seconds(transform_tolerance);
  RCLCPP_INFO(logger_, "Setting transform_tolerance to %f", transform_tolerance);
  if (forward_prune_distance_ < 0.0) {
    RCLCPP_WARN(logger_,
                "Forward prune distance is negative, setting to max to search every point on path "
                "for the closest value.");
    forward_prune_distance_ = std::numeric_limits<double>::max();
  }
}

void DWBLocalPlanner::configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                std::string name, std::shared_ptr<tf2_ros::Buffer> tf,
                                std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) {
  node_ = parent;
  const auto node = node_.lock();
  logger_ = node->get_logger();
  clock_ = node->get_clock();
  costmap_ros_ = costmap_ros;
  tf_ = tf;
  dwb_plugin_name_ = name;
  std::string generator = "dwb_plugins::StandardTrajectoryGenerator";
  readParameters(generator);
  pub_ = std::make_unique<DWBPublisher>(node, dwb_plugin_name_);
  pub_->on_configure();
  traj_generator_ = traj_gen_loader_.createUniqueInstance(generator);
  traj_generator_->initialize(node, dwb_plugin_name_);
  try {
    loadCritics();
  } catch (const std::exception& error) {
    const std::string text =
        std::string("Couldn't load critics! Caught exception: ") + error.what();
    RCLCPP_ERROR(logger_, "%s", text.c_str());
    throw nav2_core::ControllerException(text);
  }
}

void DWBLocalPlanner::activate() {
  pub_->on_activate();
}

void DWBLocalPlanner::deactivate() {
  pub_->on_deactivate();
}

void DWBLocalPlanner::cleanup() {
  pub_->on_cleanup();
  critics_.clear();
  traj_generator_.reset();
}

std::string DWBLocalPlanner::resolveCriticClassName(std::string base_name) {
  if (base_name.find("Critic") == std::string::npos) base_name += "Critic";
  if (base_name.find("::") != std::string::npos) return base_name;
  for (const std::string& space : default_critic_namespaces_) {
    const std::string full = space + "::" + base_name;
    if (critic_loader_.isClassAvailable(full)) return full;
  }
  return base_name;
}

void DWBLocalPlanner::loadCritics() {
  const auto node = node_.lock();
  if (!node) throw std::runtime_error{"Failed to lock node"};
  if (default_critic_namespaces_.empty()) default_critic_namespaces_.emplace_back("dwb_critics");
  std::vector<std::string> names;
  if (!node->get_parameter(dwb_plugin_name_ + ".critics", names)) {
    throw std::runtime_error("No critics defined for " + dwb_plugin_name_);
  }
  for (const std::string& name : names) loadCritic(node, name);
}

void DWBLocalPlanner::loadCritic(const nav2_util::LifecycleNode::SharedPtr& node,
                                 const std::string& name) {
  const std::string parameter = dwb_plugin_name_ + "." + name + ".class";
  declare_parameter_if_not_declared(node, parameter, rclcpp::ParameterValue(name));
  const std::string type = resolveCriticClassName(node->get_parameter(parameter).as_string());
  const TrajectoryCritic::Ptr critic = critic_loader_.createUniqueInstance(type);
  RCLCPP_INFO(logger_, "Using critic \"%s\" (%s)", name.c_str(), type.c_str());
  critics_.push_back(critic);
  try {
    critic->initialize(node, name, dwb_plugin_name_, costmap_ros_);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(logger_, "Couldn't initialize critic plugin!");
    throw nav2_core::ControllerException(std::string("Couldn't initialize critic plugin: ") +
                                         error.what());
  }
  RCLCPP_INFO(logger_, "Critic plugin initialized");
}

void DWBLocalPlanner::setPlan(const nav_msgs::msg::Path& path) {
  nav_2d_msgs::msg::Path2D plan = nav_2d_utils::pathToPath2D(path);
  for (auto& pose : plan.poses) {
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y)) {
      throw nav2_core::InvalidPath("Received plan with a pose that is not finite");
    }
    // An orientation of zeros has no direction.
    if (!std::isfinite(pose.theta)) pose.theta = 0.0;
  }
  for (const TrajectoryCritic::Ptr& critic : critics_) critic->reset();
  traj_generator_->reset();
  pub_->publishGlobalPlan(plan);
  global_plan_ = std::move(plan);
}

geometry_msgs::msg::TwistStamped DWBLocalPlanner::computeVelocityCommands(
    const geometry_msgs::msg::PoseStamped& pose, const geometry_msgs::msg::Twist& velocity,
    nav2_core::GoalChecker* /*goal_checker*/) {
  std::shared_ptr<LocalPlanEvaluation> results;
  if (pub_->shouldRecordEvaluation()) results = std::make_shared<LocalPlanEvaluation>();
  try {
    const Twist2DStamped chosen = computeVelocityCommands(
        nav_2d_utils::poseStampedToPose2D(pose), nav_2d_utils::twist3Dto2D(velocity), results);
    pub_->publishEvaluation(results);
    geometry_msgs::msg::TwistStamped command;
    command.twist = nav_2d_utils::twist2Dto3D(chosen.velocity);
    return command;
  } catch (const nav2_core::ControllerException&) {
    pub_->publishEvaluation(results);
    throw;
  }
}

Twist2DStamped DWBLocalPlanner::computeVelocityCommands(
    const Pose2DStamped& pose, const Twist2D& velocity,
    std::shared_ptr<LocalPlanEvaluation>& results) {
  if (results) {
    results->header.frame_id = pose.header.frame_id;
    results->header.stamp = clock_->now();
  }
  nav_2d_msgs::msg::Path2D plan;
  Pose2DStamped goal;
  prepareGlobalPlan(pose, plan, goal);
  std::unique_lock<nav2_costmap_2d::Costmap2D::mutex_t> lock(
      *costmap_ros_->getCostmap()->getMutex());
  for (const TrajectoryCritic::Ptr& critic : critics_) {
    if (!critic->prepare(pose.pose, velocity, goal.pose, plan)) {
      RCLCPP_WARN(rclcpp::get_logger("DWBLocalPlanner"), "A scoring function failed to prepare");
    }
  }
  try {
    const Trajectory2D best = coreScoringAlgorithm(pose.pose, velocity, results).traj;
    lock.unlock();
    conclude(pose, best);
    Twist2DStamped command;
    command.header.stamp = clock_->now();
    command.velocity = best.velocity;
    return command;
  } catch (const NoLegalTrajectoriesException& error) {
    lock.unlock();
    conclude(pose, Trajectory2D());
    throw nav2_core::NoValidControl(std::string("Could not find a legal trajectory: ") +
                                    error.what());
  }
}

void DWBLocalPlanner::conclude(const Pose2DStamped& pose, const Trajectory2D& chosen) {
  for (const TrajectoryCritic::Ptr& critic : critics_) critic->debrief(chosen.velocity);
  pub_->publishLocalPlan(pose.header, chosen);
  pub_->publishCostGrid(costmap_ros_, critics_);
}

}  // namespace dwb_core

PLUGINLIB_EXPORT_CLASS(dwb_core::DWBLocalPlanner, nav2_core::Controller)
