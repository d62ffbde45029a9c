// Runs behaviours of the robot, such as a spin. Each is a plugin with an action of its own; the
// server has the transforms, costmaps and outlines that they share.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_core/behavior.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "pluginlib/class_loader.hpp"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/transform_listener.h"

namespace behavior_server {

class BehaviorServer : public nav2_util::LifecycleNode {
 public:
  explicit BehaviorServer(const rclcpp::NodeOptions& options = rclcpp::NodeOptions());
  ~BehaviorServer();

 protected:
  /// False, with the reason logged, when one of them cannot be made.
  bool loadBehaviorPlugins();
  void configureBehaviorPlugins();
  /// Subscribes to the costmaps that the behaviours need.
  void setupResourcesForBehaviorPlugins();

  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  std::shared_ptr<tf2_ros::Buffer> tf_;
  std::shared_ptr<tf2_ros::TransformListener> transform_listener_;

  pluginlib::ClassLoader<nav2_core::Behavior> plugin_loader_;
  std::vector<pluginlib::UniquePtr<nav2_core::Behavior>> behaviors_;
  std::vector<std::string> default_ids_;
  std::vector<std::string> default_types_;
  std::vector<std::string> behavior_ids_;
  std::vector<std::string> behavior_types_;

  std::unique_ptr<nav2_costmap_2d::CostmapSubscriber> local_costmap_sub_;
  std::unique_ptr<nav2_costmap_2d::FootprintSubscriber> local_footprint_sub_;
  std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> local_collision_checker_;
  std::unique_ptr<nav2_costmap_2d::CostmapSubscriber> global_costmap_sub_;
  std::unique_ptr<nav2_costmap_2d::FootprintSubscriber> global_footprint_sub_;
  std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> global_collision_checker_;

 private:
  /// Makes the parts for checks against one costmap; `which` is `local` or `global`, as in the
  /// parameters.
  void subscribe(const std::string& which,
                 std::unique_ptr<nav2_costmap_2d::CostmapSubscriber>& costmap,
                 std::unique_ptr<nav2_costmap_2d::FootprintSubscriber>& footprint,
                 std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker>& checker);
};

}  // namespace behavior_server
