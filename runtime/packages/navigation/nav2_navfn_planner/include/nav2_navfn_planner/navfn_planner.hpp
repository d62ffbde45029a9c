// The planner plugin of the navigation function.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_core/global_planner.hpp"
#include "nav2_core/planner_exceptions.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_navfn_planner/navfn.hpp"
#include "nav_msgs/msg/path.hpp"

namespace nav2_navfn_planner {

class NavfnPlanner : public nav2_core::GlobalPlanner {
 public:
  NavfnPlanner() = default;
  ~NavfnPlanner();

  void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
                 std::shared_ptr<tf2_ros::Buffer> tf,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override;
  void cleanup() override;
  void activate() override;
  void deactivate() override;
  using nav2_core::GlobalPlanner::createPlan;
  nav_msgs::msg::Path createPlan(const geometry_msgs::msg::PoseStamped& start,
                                 const geometry_msgs::msg::PoseStamped& goal,
                                 std::function<bool()> cancel_checker) override;

 protected:
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

 private:
  using Pose = geometry_msgs::msg::Pose;
  using Path = nav_msgs::msg::Path;

  void checkBounds(const Pose& start, const Pose& goal) const;
  /// Throws a PlannerException when start or goal cannot be used.
  void takeCosts(const Pose& start, const Pose& goal);
  bool makePlan(const Pose& start, const Pose& goal, const std::function<bool()>& cancel_checker,
                Path& plan);
  bool findReachable(const Pose& goal, Pose& best) const;
  bool fillPlan(const Pose& best, Path& plan) const;
  void approachGoal(const Pose& goal, Path& plan) const;
  void turnAlongPath(Path& plan) const;
  bool cell_of(double wx, double wy, Cell& cell) const;

  /// Where the costs of the planner are in the world: the costmap may get another size meanwhile.
  struct Place {
    double origin_x = 0.0;
    double origin_y = 0.0;
    double resolution = 1.0;
  };

  std::unique_ptr<NavFn> planner_;
  Place place_;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("NavfnPlanner")};
  nav2_costmap_2d::Costmap2D* costmap_ = nullptr;
  std::string global_frame_;
  std::string name_;
  bool allow_unknown_ = true;
  bool use_final_approach_orientation_ = false;
  double tolerance_ = 0.5;  // m
  bool use_astar_ = false;
  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
};

}  // namespace nav2_navfn_planner
