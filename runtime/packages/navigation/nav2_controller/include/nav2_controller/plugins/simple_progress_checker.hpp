// The robot gets on when it moves far enough in a time.
#pragma once

#include <string>
#include <vector>

#include "geometry_msgs/msg/pose2_d.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_core/progress_checker.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_controller {

class SimpleProgressChecker : public nav2_core::ProgressChecker {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                  const std::string& plugin_name) override;
  bool check(geometry_msgs::msg::PoseStamped& current_pose) override;
  void reset() override;

 protected:
  /// Whether it moved far enough from the baseline.
  virtual bool hasMoved(const geometry_msgs::msg::Pose2D& pose) const;
  virtual rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

  rclcpp::Clock::SharedPtr clock_;
  double radius_ = 0.5;  // m
  rclcpp::Duration time_allowance_{10, 0};
  geometry_msgs::msg::Pose2D baseline_pose_;
  rclcpp::Time baseline_time_;
  bool baseline_pose_set_ = false;
  std::string plugin_name_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
};

}  // namespace nav2_controller
