// See managed_node.hpp.
#include "nav2_lifecycle_manager/detail/managed_node.hpp"

#include <stdexcept>
#include <utility>

namespace nav2_lifecycle_manager {
namespace detail {
namespace {

using namespace std::chrono_literals;
using lifecycle_msgs::srv::ChangeState;
using lifecycle_msgs::srv::GetState;

constexpr std::chrono::nanoseconds kStateTimeout = 2s;
constexpr std::chrono::nanoseconds kChangeTimeout = 5s;  // until the service is there
constexpr std::chrono::nanoseconds kLook = 10ms;
constexpr double kHeartbeatPeriod = 0.10;  // s

template <typename ServiceT>
auto make_client(const NodeLink& link, const std::string& name) {
  return link.node->create_client<ServiceT>(name, rclcpp::SystemDefaultsQoS(), link.group);
}

void require(rclcpp::ClientBase& client, std::chrono::nanoseconds timeout, const char* name) {
  if (!client.wait_for_service(timeout)) {
    throw std::runtime_error(std::string(name) + " service is not available!");
  }
}

}  // namespace

ManagedNode::ManagedNode(std::string name, std::shared_ptr<NodeLink> link)
    : name_(std::move(name)),
      link_(std::move(link)),
      change_state_(make_client<ChangeState>(*link_, name_ + "/change_state")),
      get_state_(make_client<GetState>(*link_, name_ + "/get_state")) {}

void ManagedNode::wait_for_services() const {
  while (!get_state_->wait_for_service(2s)) {
    if (!rclcpp::ok()) return;
    RCLCPP_INFO(link_->node->get_logger(), "Waiting for service %s...",
                (name_ + "/get_state").c_str());
  }
}

template <typename ServiceT>
typename ServiceT::Response::SharedPtr ManagedNode::ask(
    rclcpp::Client<ServiceT>& client, typename ServiceT::Request::SharedPtr request,
    std::chrono::nanoseconds timeout) {
  auto future = client.async_send_request(request);
  // In slices, since an end that is asked for between two waits would not be seen by the next one.
  constexpr std::chrono::nanoseconds kSlice = 250ms;
  const auto began = std::chrono::steady_clock::now();
  while (rclcpp::ok() && !link_->is_ending) {
    if (link_->executor.spin_until_future_complete(future, kSlice) ==
        rclcpp::FutureReturnCode::SUCCESS)
      return future.get();
    if (timeout >= 0ns && std::chrono::steady_clock::now() - began >= timeout) break;
  }
  client.remove_pending_request(future);
  return nullptr;
}

bool ManagedNode::change_state(std::uint8_t transition) {
  require(*change_state_, kChangeTimeout, "change_state");
  auto request = std::make_shared<ChangeState::Request>();
  request->transition.id = transition;
  return ask<ChangeState>(*change_state_, request, -1ns) != nullptr;
}

std::uint8_t ManagedNode::get_state() {
  require(*get_state_, kStateTimeout, "get_state");
  const auto response =
      ask<GetState>(*get_state_, std::make_shared<GetState::Request>(), kStateTimeout);
  if (response == nullptr) {
    throw std::runtime_error(name_ + "/get_state service client: async_send_request failed");
  }
  return response->current_state.id;
}

bool ManagedNode::form_bond(std::chrono::nanoseconds timeout) {
  rclcpp::Node& node = *link_->node;
  // Not a member of this object: the node may let go of it while this waits.
  const auto is_formed = std::make_shared<bool>(false);
  const auto bond = std::make_shared<bond::Bond>(
      "bond", name_, node.get_node_base_interface(), node.get_node_logging_interface(),
      node.get_node_parameters_interface(), node.get_node_timers_interface(),
      node.get_node_topics_interface(), nullptr, [is_formed] { *is_formed = true; }, link_->group);
  bond->setHeartbeatTimeout(std::chrono::duration<double>(timeout).count());
  bond->setHeartbeatPeriod(kHeartbeatPeriod);
  bond->start();
  bond_ = bond;
  rclcpp::Clock clock(RCL_STEADY_TIME);
  const rclcpp::Time end = clock.now() + rclcpp::Duration(timeout / 2);
  while (rclcpp::ok() && !*is_formed && clock.now() < end) link_->executor.spin_once(kLook);
  return *is_formed;
}

}  // namespace detail
}  // namespace nav2_lifecycle_manager
