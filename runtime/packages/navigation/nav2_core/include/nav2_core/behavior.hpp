// The base of plugins with a behaviour of the robot, such as a spin: each is an action server.
#pragma once

#include <memory>
#include <string>

#include "nav2_costmap_2d/costmap_topic_collision_checker.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_core {

/// The costmaps that a behaviour needs.
enum class CostmapInfoType { NONE = 0, LOCAL = 1, GLOBAL = 2, BOTH = 3 };

class Behavior {
 public:
  using Ptr = std::shared_ptr<Behavior>;
  virtual ~Behavior() {}

  virtual void configure(
      const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, const std::string& name,
      std::shared_ptr<tf2_ros::Buffer> tf,
      std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> local_collision_checker,
      std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> global_collision_checker) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
  virtual CostmapInfoType getResourceInfo() = 0;
};

}  // namespace nav2_core
