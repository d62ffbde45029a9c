// Leads another node through its managed life.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/service_client.hpp"

namespace nav2_util {

class LifecycleServiceClient {
 public:
  /// Wait until the node is there.
  explicit LifecycleServiceClient(const std::string& lifecycle_node_name);
  LifecycleServiceClient(const std::string& lifecycle_node_name,
                         rclcpp::Node::SharedPtr parent_node);
  ~LifecycleServiceClient() {
    change_state_.stop();
    get_state_.stop();
  }

  /// `transition` is an id of lifecycle_msgs/Transition. True when an answer came, whatever it
  /// says. Throws std::runtime_error when the service is not there or does not answer in time.
  bool change_state(const uint8_t transition, const std::chrono::seconds timeout);
  bool change_state(std::uint8_t transition);
  /// An id of lifecycle_msgs/State. Throws std::runtime_error as change_state().
  uint8_t get_state(const std::chrono::seconds timeout = std::chrono::seconds(2));

 protected:
  rclcpp::Node::SharedPtr node_;
  ServiceClient<lifecycle_msgs::srv::ChangeState> change_state_;
  ServiceClient<lifecycle_msgs::srv::GetState> get_state_;
};

}  // namespace nav2_util
