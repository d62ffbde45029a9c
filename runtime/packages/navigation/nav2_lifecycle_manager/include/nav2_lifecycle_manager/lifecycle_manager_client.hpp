// Asks a lifecycle manager to start, pause, reset or end its nodes.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "nav2_msgs/action/navigate_to_pose.hpp"
#include "nav2_msgs/srv/manage_lifecycle_nodes.hpp"
#include "nav2_util/service_client.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_srvs/srv/empty.hpp"
#include "std_srvs/srv/trigger.hpp"

namespace nav2_lifecycle_manager {

enum class SystemStatus { ACTIVE, INACTIVE, TIMEOUT };

class LifecycleManagerClient {
 public:
  /// `name` is that of the manager.
  explicit LifecycleManagerClient(const std::string& name,
                                  std::shared_ptr<rclcpp::Node> parent_node);

  /// Each waits for the manager to finish, and returns whether it succeeded. Negative: no limit.
  bool startup(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  bool shutdown(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  bool pause(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  bool resume(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  bool reset(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  bool configure(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  bool cleanup(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  SystemStatus is_active(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));

 protected:
  using ManageLifecycleNodes = nav2_msgs::srv::ManageLifecycleNodes;

  bool callService(uint8_t command,
                   const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));

  rclcpp::Node::SharedPtr node_;
  std::shared_ptr<nav2_util::ServiceClient<ManageLifecycleNodes>> manager_client_;
  std::shared_ptr<nav2_util::ServiceClient<std_srvs::srv::Trigger>> is_active_client_;
  std::string manage_service_name_;
  std::string active_service_name_;
};

}  // namespace nav2_lifecycle_manager
