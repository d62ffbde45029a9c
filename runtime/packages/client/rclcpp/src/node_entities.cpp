// Entering publishers, subscriptions, timers, services, clients and waitables into a node.
#include <stdexcept>
#include <string>

#include "rclcpp/detail/executable.hpp"
#include "rclcpp/detail/intra_process.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/node_interfaces/node_services.hpp"
#include "rclcpp/node_interfaces/node_timers.hpp"
#include "rclcpp/node_interfaces/node_topics.hpp"
#include "rclcpp/node_interfaces/node_waitables.hpp"

namespace rclcpp {
namespace node_interfaces {
namespace {

rclcpp::CallbackGroup::SharedPtr choose_group(NodeBaseInterface& node,
                                              rclcpp::CallbackGroup::SharedPtr group,
                                              const char* what) {
  if (!group) {
    return node.get_default_callback_group();
  }
  if (!node.callback_group_in_node(group)) {
    throw exceptions::MissingGroupNodeException(what);
  }
  return group;
}

}  // namespace

void NodeTopics::add_publisher(rclcpp::PublisherBase::SharedPtr publisher,
                               rclcpp::CallbackGroup::SharedPtr callback_group) {
  const auto group = choose_group(*node_base_, std::move(callback_group), "publisher");
  for (const auto& [type, handler] : publisher->get_event_handlers()) {
    group->add_waitable(handler);
  }
  if (!publisher->get_event_handlers().empty()) {
    detail::bump_entities_version();
  }
}

void NodeTopics::add_subscription(rclcpp::SubscriptionBase::SharedPtr subscription,
                                  rclcpp::CallbackGroup::SharedPtr callback_group) {
  const auto group = choose_group(*node_base_, std::move(callback_group), "subscription");
  group->add_subscription(subscription);
  for (const auto& [type, handler] : subscription->get_event_handlers()) {
    group->add_waitable(handler);
  }
  if (subscription->is_intra_process()) {
    detail::add_local_subscription(subscription);
  }
  detail::bump_entities_version();
}

std::string NodeTopics::resolve_topic_name(const std::string& name, bool only_expand) const {
  return node_base_->resolve_topic_or_service_name(name, false, only_expand);
}

void NodeTimers::add_timer(rclcpp::TimerBase::SharedPtr timer,
                           rclcpp::CallbackGroup::SharedPtr callback_group) {
  choose_group(*node_base_, std::move(callback_group), "timer")->add_timer(timer);
  detail::bump_entities_version();
}

void NodeServices::add_client(rclcpp::ClientBase::SharedPtr client_base_ptr,
                              rclcpp::CallbackGroup::SharedPtr group) {
  choose_group(*node_base_, std::move(group), "client")->add_client(client_base_ptr);
  detail::bump_entities_version();
}

void NodeServices::add_service(rclcpp::ServiceBase::SharedPtr service_base_ptr,
                               rclcpp::CallbackGroup::SharedPtr group) {
  choose_group(*node_base_, std::move(group), "service")->add_service(service_base_ptr);
  detail::bump_entities_version();
}

std::string NodeServices::resolve_service_name(const std::string& name, bool only_expand) const {
  return node_base_->resolve_topic_or_service_name(name, true, only_expand);
}

void NodeWaitables::add_waitable(rclcpp::Waitable::SharedPtr waitable_base_ptr,
                                 rclcpp::CallbackGroup::SharedPtr group) {
  choose_group(*node_base_, std::move(group), "waitable")->add_waitable(waitable_base_ptr);
  detail::bump_entities_version();
}

void NodeWaitables::remove_waitable(rclcpp::Waitable::SharedPtr waitable_ptr,
                                    rclcpp::CallbackGroup::SharedPtr group) noexcept {
  (group ? group : node_base_->get_default_callback_group())->remove_waitable(waitable_ptr);
  detail::bump_entities_version();
}

}  // namespace node_interfaces
}  // namespace rclcpp
