// The part of action clients that knows no action type.
#include "rclcpp_action/client.hpp"

#include "rclcpp/detail/background.hpp"
#include "rclcpp/node_interfaces/node_services.hpp"
#include "rclcpp/node_interfaces/node_topics.hpp"
#include "ros2wasm/endpoint.hpp"

rcl_action_client_options_t rcl_action_client_get_default_options() {
  rcl_action_client_options_t options{};
  options.goal_service_qos = rmw_qos_profile_services_default;
  options.result_service_qos = rmw_qos_profile_services_default;
  options.cancel_service_qos = rmw_qos_profile_services_default;
  options.feedback_topic_qos = rmw_qos_profile_default;
  options.status_topic_qos = rmw_qos_profile_default;
  options.status_topic_qos.depth = 1;
  options.status_topic_qos.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  return options;
}

namespace rclcpp_action {

ClientBase::ClientBase(rclcpp::node_interfaces::NodeBaseInterface* node_base,
                       rclcpp::CallbackGroup::SharedPtr group)
    : node_base_(node_base), group_(std::move(group)) {}

ClientBase::~ClientBase() = default;

rclcpp::QoS ClientBase::qos_of(const rmw_qos_profile_t& profile) {
  return rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(profile), profile);
}

void ClientBase::add_client(const rclcpp::ClientBase::SharedPtr& client) {
  rclcpp::node_interfaces::NodeServices(node_base_).add_client(client, group_);
  clients_.push_back(client);
}

void ClientBase::add_subscription(const rclcpp::SubscriptionBase::SharedPtr& subscription) {
  rclcpp::node_interfaces::NodeTopics(node_base_, nullptr).add_subscription(subscription, group_);
  subscriptions_.push_back(subscription);
}

bool ClientBase::action_server_is_ready() const {
  for (const auto& client : clients_) {
    if (!client->service_is_ready()) {
      return false;
    }
  }
  for (const auto& subscription : subscriptions_) {
    if (subscription->get_publisher_count() == 0) {
      return false;
    }
  }
  return true;
}

bool ClientBase::wait_for_action_server_nanoseconds(std::chrono::nanoseconds timeout) {
  const auto context = node_base_->get_context();
  const bool limited = timeout.count() >= 0;
  const int64_t until = ros2wasm::steady_now_ns() + timeout.count();
  while (true) {
    const int32_t token = ros2wasm::wake_token();
    if (action_server_is_ready()) {
      return true;
    }
    const int64_t left = limited ? until - ros2wasm::steady_now_ns() : -1;
    if (!context->is_valid() || (limited && left <= 0)) {
      return false;
    }
    rclcpp::detail::run_background();
    ros2wasm::wait(token, left);
  }
}

}  // namespace rclcpp_action
