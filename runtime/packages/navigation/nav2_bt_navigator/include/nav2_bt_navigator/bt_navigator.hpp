// The server of navigators: each plugin is an action, and leads a behavior tree.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_core/behavior_tree_navigator.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/odometry_utils.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

namespace nav2_bt_navigator {

class BtNavigator : public nav2_util::LifecycleNode {
 public:
  explicit BtNavigator(rclcpp::NodeOptions options = rclcpp::NodeOptions());
  /// Ends the goals of a node that is active.
  ~BtNavigator() override;

 protected:
  nav2_util::CallbackReturn on_configure(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_activate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_deactivate(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_cleanup(const rclcpp_lifecycle::State& state) override;
  nav2_util::CallbackReturn on_shutdown(const rclcpp_lifecycle::State& state) override;

  // The loader outlives what it made.
  pluginlib::ClassLoader<nav2_core::NavigatorBase> class_loader_;
  std::vector<pluginlib::UniquePtr<nav2_core::NavigatorBase>> navigators_;
  nav2_core::NavigatorMuxer plugin_muxer_;
  std::shared_ptr<nav2_util::OdomSmoother> odom_smoother_;
  std::shared_ptr<tf2_ros::Buffer> tf_;
  std::shared_ptr<tf2_ros::TransformListener> tf_listener_;

 private:
  std::vector<std::string> navigator_ids();
  /// Throws what a plugin throws. False: it cannot be configured.
  bool add_navigator(const std::string& id, const std::vector<std::string>& libraries,
                     const nav2_core::FeedbackUtils& feedback);
};

}  // namespace nav2_bt_navigator
