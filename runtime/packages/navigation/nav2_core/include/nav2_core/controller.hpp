// The base of plugins that follow a path.
#pragma once

#include <memory>
#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_core/controller_exceptions.hpp"
#include "nav2_core/goal_checker.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "nav_msgs/msg/path.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "tf2_ros/transform_listener.h"

namespace nav2_core {

class Controller {
 public:
  using Ptr = std::shared_ptr<nav2_core::Controller>;
  virtual ~Controller() {}

  virtual void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
                         std::shared_ptr<tf2_ros::Buffer> tf,
                         std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
  virtual void setPlan(const nav_msgs::msg::Path& path) = 0;
  /// `pose` in the frame of the local costmap. Throws a ControllerException.
  virtual geometry_msgs::msg::TwistStamped computeVelocityCommands(
      const geometry_msgs::msg::PoseStamped& pose, const geometry_msgs::msg::Twist& velocity,
      nav2_core::GoalChecker* goal_checker) = 0;
  /// Whether the controller may be stopped now; false: it is asked again, to brake by itself.
  virtual bool cancel() { return true; }
  /// In m/s, or with `percentage` in percent of the greatest speed; 0: no limit.
  virtual void setSpeedLimit(const double& speed_limit, const bool& percentage) = 0;
  /// The goal has ended.
  virtual void reset() {}
};

}  // namespace nav2_core
