// The base of plugins that smooth a path.
#pragma once

#include <memory>
#include <string>

#include "nav2_core/smoother_exceptions.hpp"
#include "nav2_costmap_2d/costmap_subscriber.hpp"
#include "nav2_costmap_2d/footprint_subscriber.hpp"
#include "nav_msgs/msg/path.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

namespace nav2_core {

class Smoother {
 public:
  using Ptr = std::shared_ptr<nav2_core::Smoother>;
  virtual ~Smoother() {}

  virtual void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
                         std::shared_ptr<tf2_ros::Buffer> tf,
                         std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_sub,
                         std::shared_ptr<nav2_costmap_2d::FootprintSubscriber> footprint_sub) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
  /// Whether it was done within the time. Throws a SmootherException.
  virtual bool smooth(nav_msgs::msg::Path& path, const rclcpp::Duration& max_time) = 0;
};

}  // namespace nav2_core
