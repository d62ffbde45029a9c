// The parameters of a controller's init.
#pragma once

#include <string>
#include <unordered_map>

#include "joint_limits/joint_limits.hpp"
#include "rclcpp/node_options.hpp"

namespace controller_interface {

struct ControllerInterfaceParams {
  ControllerInterfaceParams() = default;

  std::string controller_name = "";
  std::string robot_description = "";
  unsigned int update_rate = 0;                     ///< Hz
  unsigned int controller_manager_update_rate = 0;  ///< Hz
  std::string node_namespace = "";
  rclcpp::NodeOptions node_options = rclcpp::NodeOptions();
  std::unordered_map<std::string, joint_limits::JointLimits> hard_joint_limits = {};
  std::unordered_map<std::string, joint_limits::SoftJointLimits> soft_joint_limits = {};
};

}  // namespace controller_interface
