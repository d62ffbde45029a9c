// See lifecycle_service_client.hpp.
#include "nav2_util/lifecycle_service_client.hpp"

#include <stdexcept>
#include <string>

namespace nav2_util {
namespace {

using namespace std::chrono_literals;

template <typename ServiceT>
void wait_for(const rclcpp::Node::SharedPtr& node, ServiceClient<ServiceT>& client) {
  while (!client.wait_for_service(2s)) {
    if (!rclcpp::ok()) return;
    RCLCPP_INFO(node->get_logger(), "Waiting for service %s...", client.getServiceName().c_str());
  }
}

template <typename ServiceT>
void require(ServiceClient<ServiceT>& client, std::chrono::nanoseconds timeout, const char* name) {
  if (!client.wait_for_service(timeout)) {
    throw std::runtime_error(std::string(name) + " service is not available!");
  }
}

auto request_of(uint8_t transition) {
  auto request = std::make_shared<lifecycle_msgs::srv::ChangeState::Request>();
  request->transition.id = transition;
  return request;
}

}  // namespace

LifecycleServiceClient::LifecycleServiceClient(const std::string& lifecycle_node_name)
    : LifecycleServiceClient(lifecycle_node_name,
                             generate_internal_node(lifecycle_node_name + "_lifecycle_client")) {}

LifecycleServiceClient::LifecycleServiceClient(const std::string& lifecycle_node_name,
                                               rclcpp::Node::SharedPtr parent_node)
    : node_(parent_node),
      change_state_(lifecycle_node_name + "/change_state", node_),
      get_state_(lifecycle_node_name + "/get_state", node_) {
  wait_for(node_, get_state_);
}

bool LifecycleServiceClient::change_state(const uint8_t transition,
                                          const std::chrono::seconds timeout) {
  require(change_state_, timeout, "change_state");
  auto request = request_of(transition);
  return change_state_.invoke(request, timeout) != nullptr;
}

bool LifecycleServiceClient::change_state(std::uint8_t transition) {
  require(change_state_, 5s, "change_state");
  auto request = request_of(transition);
  auto response = std::make_shared<lifecycle_msgs::srv::ChangeState::Response>();
  return change_state_.invoke(request, response);
}

uint8_t LifecycleServiceClient::get_state(const std::chrono::seconds timeout) {
  require(get_state_, timeout, "get_state");
  auto request = std::make_shared<lifecycle_msgs::srv::GetState::Request>();
  return get_state_.invoke(request, timeout)->current_state.id;
}

}  // namespace nav2_util
