// See lifecycle_manager_client.hpp.
#include "nav2_lifecycle_manager/lifecycle_manager_client.hpp"

#include <stdexcept>

namespace nav2_lifecycle_manager {

using Command = nav2_msgs::srv::ManageLifecycleNodes::Request;

LifecycleManagerClient::LifecycleManagerClient(const std::string& name,
                                               std::shared_ptr<rclcpp::Node> parent_node)
    : node_(parent_node),
      manage_service_name_(name + "/manage_nodes"),
      active_service_name_(name + "/is_active") {
  manager_client_ =
      std::make_shared<nav2_util::ServiceClient<ManageLifecycleNodes>>(manage_service_name_, node_);
  is_active_client_ = std::make_shared<nav2_util::ServiceClient<std_srvs::srv::Trigger>>(
      active_service_name_, node_);
}

bool LifecycleManagerClient::startup(const std::chrono::nanoseconds timeout) {
  return callService(Command::STARTUP, timeout);
}
bool LifecycleManagerClient::shutdown(const std::chrono::nanoseconds timeout) {
  return callService(Command::SHUTDOWN, timeout);
}
bool LifecycleManagerClient::pause(const std::chrono::nanoseconds timeout) {
  return callService(Command::PAUSE, timeout);
}
bool LifecycleManagerClient::resume(const std::chrono::nanoseconds timeout) {
  return callService(Command::RESUME, timeout);
}
bool LifecycleManagerClient::reset(const std::chrono::nanoseconds timeout) {
  return callService(Command::RESET, timeout);
}
bool LifecycleManagerClient::configure(const std::chrono::nanoseconds timeout) {
  return callService(Command::CONFIGURE, timeout);
}
bool LifecycleManagerClient::cleanup(const std::chrono::nanoseconds timeout) {
  return callService(Command::CLEANUP, timeout);
}

SystemStatus LifecycleManagerClient::is_active(const std::chrono::nanoseconds timeout) {
  RCLCPP_DEBUG(node_->get_logger(), "Waiting for the %s service...", active_service_name_.c_str());
  if (!is_active_client_->wait_for_service(std::chrono::seconds(1))) return SystemStatus::TIMEOUT;
  RCLCPP_DEBUG(node_->get_logger(), "Sending %s request", active_service_name_.c_str());
  auto request = std::make_shared<std_srvs::srv::Trigger::Request>();
  try {
    return is_active_client_->invoke(request, timeout)->success ? SystemStatus::ACTIVE
                                                                : SystemStatus::INACTIVE;
  } catch (const std::runtime_error&) {
    return SystemStatus::TIMEOUT;
  }
}

bool LifecycleManagerClient::callService(uint8_t command, const std::chrono::nanoseconds timeout) {
  RCLCPP_DEBUG(node_->get_logger(), "Waiting for the %s service...", manage_service_name_.c_str());
  while (!manager_client_->wait_for_service(timeout)) {
    if (!rclcpp::ok()) {
      RCLCPP_ERROR(node_->get_logger(), "Client interrupted while waiting for service to appear");
      return false;
    }
    RCLCPP_DEBUG(node_->get_logger(), "Waiting for service to appear...");
  }
  RCLCPP_DEBUG(node_->get_logger(), "Sending %s request", manage_service_name_.c_str());
  auto request = std::make_shared<Command>();
  request->command = command;
  try {
    return manager_client_->invoke(request, timeout)->success;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace nav2_lifecycle_manager
