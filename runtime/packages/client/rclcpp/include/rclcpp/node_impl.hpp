// The templates of nodes.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/create_client.hpp"
#include "rclcpp/create_publisher.hpp"
#include "rclcpp/create_service.hpp"
#include "rclcpp/create_subscription.hpp"
#include "rclcpp/create_timer.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/node.hpp"

namespace rclcpp {
namespace detail {

/// `name` below a sub-node's namespace, unless it is absolute or private.
std::string extend_name_with_sub_namespace(const std::string& name,
                                           const std::string& sub_namespace);

template <typename MessageT, typename AllocatorT, typename PublisherT>
std::shared_ptr<PublisherT> CommonNode::create_publisher(
    const std::string& topic_name, const rclcpp::QoS& qos,
    const PublisherOptionsWithAllocator<AllocatorT>& options) {
  return rclcpp::create_publisher<MessageT, AllocatorT, PublisherT>(
      *this, extend_name_with_sub_namespace(topic_name, sub_namespace_), qos, options);
}

template <typename MessageT, typename CallbackT, typename AllocatorT, typename SubscriptionT,
          typename MessageMemoryStrategyT>
std::shared_ptr<SubscriptionT> CommonNode::create_subscription(
    const std::string& topic_name, const rclcpp::QoS& qos, CallbackT&& callback,
    const SubscriptionOptionsWithAllocator<AllocatorT>& options,
    typename MessageMemoryStrategyT::SharedPtr) {
  return rclcpp::create_subscription<MessageT, CallbackT, AllocatorT, SubscriptionT>(
      *this, extend_name_with_sub_namespace(topic_name, sub_namespace_), qos,
      std::forward<CallbackT>(callback), options);
}

template <typename DurationRepT, typename DurationT, typename CallbackT>
typename rclcpp::WallTimer<CallbackT>::SharedPtr CommonNode::create_wall_timer(
    std::chrono::duration<DurationRepT, DurationT> period, CallbackT callback,
    rclcpp::CallbackGroup::SharedPtr group, bool autostart) {
  return rclcpp::create_wall_timer(period, std::move(callback), std::move(group), node_base_.get(),
                                   node_timers_.get(), autostart);
}

template <typename DurationRepT, typename DurationT, typename CallbackT>
typename rclcpp::GenericTimer<CallbackT>::SharedPtr CommonNode::create_timer(
    std::chrono::duration<DurationRepT, DurationT> period, CallbackT callback,
    rclcpp::CallbackGroup::SharedPtr group) {
  return rclcpp::create_timer(get_clock(), period, std::move(callback), std::move(group),
                              node_base_.get(), node_timers_.get());
}

template <typename ServiceT>
typename Client<ServiceT>::SharedPtr CommonNode::create_client(
    const std::string& service_name, const rclcpp::QoS& qos,
    rclcpp::CallbackGroup::SharedPtr group) {
  return rclcpp::create_client<ServiceT>(
      node_base_, node_graph_, node_services_,
      extend_name_with_sub_namespace(service_name, sub_namespace_), qos, group);
}

template <typename ServiceT>
typename Client<ServiceT>::SharedPtr CommonNode::create_client(
    const std::string& service_name, const rmw_qos_profile_t& qos_profile,
    rclcpp::CallbackGroup::SharedPtr group) {
  return create_client<ServiceT>(
      service_name, rclcpp::QoS(QoSInitialization::from_rmw(qos_profile), qos_profile), group);
}

template <typename ServiceT, typename CallbackT>
typename rclcpp::Service<ServiceT>::SharedPtr CommonNode::create_service(
    const std::string& service_name, CallbackT&& callback, const rclcpp::QoS& qos,
    rclcpp::CallbackGroup::SharedPtr group) {
  return rclcpp::create_service<ServiceT, CallbackT>(
      node_base_, node_services_, extend_name_with_sub_namespace(service_name, sub_namespace_),
      std::forward<CallbackT>(callback), qos, group);
}

template <typename ServiceT, typename CallbackT>
typename rclcpp::Service<ServiceT>::SharedPtr CommonNode::create_service(
    const std::string& service_name, CallbackT&& callback, const rmw_qos_profile_t& qos_profile,
    rclcpp::CallbackGroup::SharedPtr group) {
  return create_service<ServiceT, CallbackT>(
      service_name, std::forward<CallbackT>(callback),
      rclcpp::QoS(QoSInitialization::from_rmw(qos_profile), qos_profile), group);
}

template <typename AllocatorT>
std::shared_ptr<rclcpp::GenericPublisher> CommonNode::create_generic_publisher(
    const std::string& topic_name, const std::string& topic_type, const rclcpp::QoS& qos,
    const rclcpp::PublisherOptionsWithAllocator<AllocatorT>& options) {
  return rclcpp::create_generic_publisher(
      node_topics_, extend_name_with_sub_namespace(topic_name, sub_namespace_), topic_type, qos,
      options);
}

template <typename CallbackT, typename AllocatorT>
std::shared_ptr<rclcpp::GenericSubscription> CommonNode::create_generic_subscription(
    const std::string& topic_name, const std::string& topic_type, const rclcpp::QoS& qos,
    CallbackT&& callback, const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& options) {
  return rclcpp::create_generic_subscription(
      node_topics_, extend_name_with_sub_namespace(topic_name, sub_namespace_), topic_type, qos,
      std::forward<CallbackT>(callback), options);
}

template <typename ParameterT>
auto CommonNode::declare_parameter(
    const std::string& name, const ParameterT& default_value,
    const rcl_interfaces::msg::ParameterDescriptor& parameter_descriptor, bool ignore_override) {
  try {
    return declare_parameter(name, rclcpp::ParameterValue(default_value), parameter_descriptor,
                             ignore_override)
        .get<ParameterT>();
  } catch (const ParameterTypeException& ex) {
    throw exceptions::InvalidParameterTypeException(name, ex.what());
  }
}

template <typename ParameterT>
auto CommonNode::declare_parameter(
    const std::string& name, const rcl_interfaces::msg::ParameterDescriptor& parameter_descriptor,
    bool ignore_override) {
  const rclcpp::ParameterValue value{ParameterT{}};
  try {
    return declare_parameter(name, value.get_type(), parameter_descriptor, ignore_override)
        .get<ParameterT>();
  } catch (const ParameterTypeException&) {
    throw exceptions::UninitializedStaticallyTypedParameterException(name);
  }
}

template <typename ParameterT>
std::vector<ParameterT> CommonNode::declare_parameters(
    const std::string& namespace_, const std::map<std::string, ParameterT>& parameters,
    bool ignore_overrides) {
  const std::string prefix = namespace_.empty() ? "" : namespace_ + ".";
  std::vector<ParameterT> result;
  for (const auto& [name, value] : parameters) {
    result.push_back(declare_parameter(
        prefix + name, value, rcl_interfaces::msg::ParameterDescriptor(), ignore_overrides));
  }
  return result;
}

template <typename ParameterT>
std::vector<ParameterT> CommonNode::declare_parameters(
    const std::string& namespace_,
    const std::map<std::string, std::pair<ParameterT, rcl_interfaces::msg::ParameterDescriptor>>&
        parameters,
    bool ignore_overrides) {
  const std::string prefix = namespace_.empty() ? "" : namespace_ + ".";
  std::vector<ParameterT> result;
  for (const auto& [name, value] : parameters) {
    result.push_back(static_cast<ParameterT>(
        declare_parameter(prefix + name, value.first, value.second, ignore_overrides)));
  }
  return result;
}

template <typename ParameterT>
bool CommonNode::get_parameter(const std::string& name, ParameterT& parameter) const {
  const std::string full_name = extend_name_with_sub_namespace(name, sub_namespace_);
  rclcpp::Parameter found(full_name);
  const bool result = get_parameter(full_name, found);
  if (result) {
    parameter = static_cast<ParameterT>(found.get_value<ParameterT>());
  }
  return result;
}

template <typename ParameterT>
bool CommonNode::get_parameter_or(const std::string& name, ParameterT& parameter,
                                  const ParameterT& alternative_value) const {
  const bool found = get_parameter(name, parameter);
  if (!found) {
    parameter = alternative_value;
  }
  return found;
}

template <typename ParameterT>
ParameterT CommonNode::get_parameter_or(const std::string& name,
                                        const ParameterT& alternative_value) const {
  ParameterT parameter;
  get_parameter_or(name, parameter, alternative_value);
  return parameter;
}

template <typename ParameterT>
bool CommonNode::get_parameters(const std::string& prefix,
                                std::map<std::string, ParameterT>& values) const {
  std::map<std::string, rclcpp::Parameter> found;
  const bool result = node_parameters_->get_parameters_by_prefix(prefix, found);
  for (const auto& [name, parameter] : found) {
    values[name] = static_cast<ParameterT>(parameter.get_value<ParameterT>());
  }
  return result;
}

}  // namespace detail
}  // namespace rclcpp
