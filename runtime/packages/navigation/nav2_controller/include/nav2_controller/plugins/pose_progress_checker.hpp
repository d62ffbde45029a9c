// As SimpleProgressChecker, but a turn counts as well as a move.
#pragma once

#include <string>
#include <vector>

#include "nav2_controller/plugins/simple_progress_checker.hpp"

namespace nav2_controller {

class PoseProgressChecker : public SimpleProgressChecker {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                  const std::string& plugin_name) override;

 protected:
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters) override;
  bool hasMoved(const geometry_msgs::msg::Pose2D& pose) const override;

  double required_movement_angle_ = 0.5;  // rad
};

}  // namespace nav2_controller
