// See simple_action_server.hpp.
#include "nav2_util/simple_action_server.hpp"

namespace nav2_util {

void ActionServerLog::info_msg(const char* msg) const {
  RCLCPP_INFO(node_logging_interface_->get_logger(), "[%s] [ActionServer] %s", action_name_.c_str(),
              msg);
}

void ActionServerLog::debug_msg(const char* msg) const {
  RCLCPP_DEBUG(node_logging_interface_->get_logger(), "[%s] [ActionServer] %s",
               action_name_.c_str(), msg);
}

void ActionServerLog::error_msg(const char* msg) const {
  RCLCPP_ERROR(node_logging_interface_->get_logger(), "[%s] [ActionServer] %s",
               action_name_.c_str(), msg);
}

void ActionServerLog::warn_msg(const char* msg) const {
  RCLCPP_WARN(node_logging_interface_->get_logger(), "[%s] [ActionServer] %s", action_name_.c_str(),
              msg);
}

}  // namespace nav2_util
