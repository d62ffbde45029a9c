// The base of plugins that plan a path over the global costmap.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_core/planner_exceptions.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav_msgs/msg/path.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_core {

class GlobalPlanner {
 public:
  using Ptr = std::shared_ptr<GlobalPlanner>;
  virtual ~GlobalPlanner() {}

  virtual void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
                         std::shared_ptr<tf2_ros::Buffer> tf,
                         std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;

  /// Poses are in the frame of the costmap. Throws a PlannerException. `cancel_checker` is true
  /// once nobody wants the path any more. A plugin overrides this or, as in ROS 2 Humble, the form
  /// without the checker.
  virtual nav_msgs::msg::Path createPlan(const geometry_msgs::msg::PoseStamped& start,
                                         const geometry_msgs::msg::PoseStamped& goal,
                                         std::function<bool()> cancel_checker) {
    static_cast<void>(cancel_checker);
    return createPlan(start, goal);
  }
  virtual nav_msgs::msg::Path createPlan(const geometry_msgs::msg::PoseStamped&,
                                         const geometry_msgs::msg::PoseStamped&) {
    throw PlannerException("the planner does not override createPlan()");
  }
};

}  // namespace nav2_core
