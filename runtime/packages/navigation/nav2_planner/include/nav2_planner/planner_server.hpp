// Plans paths over the global costmap, by the planner plugins that its parameters name.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_core/global_planner.hpp"
#include "nav2_core/planner_exceptions.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_costmap_2d/footprint_collision_checker.hpp"
#include "nav2_msgs/action/compute_path_through_poses.hpp"
#include "nav2_msgs/action/compute_path_to_pose.hpp"
#include "nav2_msgs/srv/is_path_valid.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/simple_action_server.hpp"
#include "nav_msgs/msg/path.hpp"
#include "pluginlib/class_loader.hpp"

namespace nav2_planner {

class PlannerServer : public nav2_util::LifecycleNode {
 public:
  explicit PlannerServer(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~PlannerServer();
  using PlannerMap = std::unordered_map<std::string, nav2_core::GlobalPlanner::Ptr>;

  /// `planner_id` empty: the only planner. Throws a PlannerException.
  nav_msgs::msg::Path getPlan(const geometry_msgs::msg::PoseStamped& start,
                              const geometry_msgs::msg::PoseStamped& goal,
                              const std::string& planner_id, std::function<bool()> cancel_checker);

 protected:
  using ActionToPose = nav2_msgs::action::ComputePathToPose;
  using ActionThroughPoses = nav2_msgs::action::ComputePathThroughPoses;
  template <typename ActionT>
  using Server = nav2_util::SimpleActionServer<ActionT>;

  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  void computePlan();
  void computePlanThroughPoses();
  void isPathValid(const std::shared_ptr<nav2_msgs::srv::IsPathValid::Request> request,
                   std::shared_ptr<nav2_msgs::srv::IsPathValid::Response> response);
  void publishPlan(const nav_msgs::msg::Path& path);
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

  std::unique_ptr<Server<ActionToPose>> action_server_pose_;
  std::unique_ptr<Server<ActionThroughPoses>> action_server_poses_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
  // Before the planners, whose code it has.
  pluginlib::ClassLoader<nav2_core::GlobalPlanner> gp_loader_;
  PlannerMap planners_;
  std::vector<std::string> planner_ids_;
  std::string planner_ids_concat_;
  std::atomic<double> max_planner_duration_{0.0};  // s; 0: any
  rclcpp::Duration costmap_update_timeout_;
  std::shared_ptr<tf2_ros::Buffer> tf_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros_;
  std::unique_ptr<nav2_util::NodeThread> costmap_thread_;
  nav2_costmap_2d::Costmap2D* costmap_ = nullptr;
  std::unique_ptr<nav2_costmap_2d::FootprintCollisionChecker<nav2_costmap_2d::Costmap2D*>>
      collision_checker_;
  rclcpp_lifecycle::LifecyclePublisher<nav_msgs::msg::Path>::SharedPtr plan_publisher_;
  rclcpp::Service<nav2_msgs::srv::IsPathValid>::SharedPtr is_path_valid_service_;

 private:
  using Pose = geometry_msgs::msg::PoseStamped;
  using Path = nav_msgs::msg::Path;

  bool loadPlanners();
  /// Answers the goal of an action with what `plan` makes of it, or with the code of its error.
  template <typename ActionT, typename PlanT>
  void answer(Server<ActionT>& server, PlanT plan);
  template <typename GoalT>
  Pose startOf(const GoalT& goal);
  void waitForCostmap(const std::function<bool()>& is_active);
  Path planBetween(Pose start, Pose goal, const std::string& planner_id,
                   const std::function<bool()>& is_cancelled);
  void setExpectedFrequency(double frequency);
  bool isPoseFree(const geometry_msgs::msg::Pose& pose) const;
  // The poses that a warning about a failure names.
  std::mutex planning_lock_;  // one path at a time
  Pose last_start_;
  Pose last_goal_;
};

}  // namespace nav2_planner
