// The limits of a robot as parameters of the controller, which may change at any time.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "dwb_plugins/kinematic_limits.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"

namespace dwb_plugins {

class KinematicsHandler {
 public:
  KinematicsHandler();
  ~KinematicsHandler();
  /// Throws std::runtime_error for a limit that is not a finite number.
  void initialize(const nav2_util::LifecycleNode::SharedPtr& nh, const std::string& plugin_name);
  inline KinematicParameters getKinematics() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return kinematics_;
  }
  /// A limit that is negative or not finite is ignored, with an error.
  void setSpeedLimit(const double& speed_limit, const bool& percentage);

  using Ptr = std::shared_ptr<KinematicsHandler>;

 protected:
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);
  void update_kinematics(KinematicParameters kinematics);

  nav2_util::LifecycleNode::WeakPtr node_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
  rclcpp::node_interfaces::PostSetParametersCallbackHandle::SharedPtr post_set_handler_;
  std::string plugin_name_;

 private:
  struct Row;
  static const std::vector<Row>& rows();
  static bool write(KinematicParameters& kinematics, const Row& row, double value);
  /// Returns the name of a parameter whose value cannot be used; empty when all are taken.
  std::string change(KinematicParameters& kinematics,
                     const std::vector<rclcpp::Parameter>& parameters) const;

  std::mutex mutex_;
  KinematicParameters kinematics_;
};

}  // namespace dwb_plugins
