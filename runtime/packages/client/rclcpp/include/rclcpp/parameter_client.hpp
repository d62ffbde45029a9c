// Clients of another node's parameter services: with futures, and blocking.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/list_parameters_result.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/create_subscription.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/parameter_map.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp {

class AsyncParametersClient {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(AsyncParametersClient)

  /// `remote_node_name` empty: the node itself.
  AsyncParametersClient(
      const node_interfaces::NodeBaseInterface::SharedPtr node_base_interface,
      const node_interfaces::NodeTopicsInterface::SharedPtr node_topics_interface,
      const node_interfaces::NodeGraphInterface::SharedPtr node_graph_interface,
      const node_interfaces::NodeServicesInterface::SharedPtr node_services_interface,
      const std::string& remote_node_name = "",
      const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS(),
      rclcpp::CallbackGroup::SharedPtr group = nullptr);

  template <typename NodeT>
  explicit AsyncParametersClient(const std::shared_ptr<NodeT> node,
                                 const std::string& remote_node_name = "",
                                 const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS(),
                                 rclcpp::CallbackGroup::SharedPtr group = nullptr)
      : AsyncParametersClient(node.get(), remote_node_name, qos_profile, group) {}

  template <typename NodeT>
  explicit AsyncParametersClient(NodeT* node, const std::string& remote_node_name = "",
                                 const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS(),
                                 rclcpp::CallbackGroup::SharedPtr group = nullptr)
      : AsyncParametersClient(node->get_node_base_interface(), node->get_node_topics_interface(),
                              node->get_node_graph_interface(), node->get_node_services_interface(),
                              remote_node_name, qos_profile, group) {}

  std::shared_future<std::vector<rclcpp::Parameter>> get_parameters(
      const std::vector<std::string>& names,
      std::function<void(std::shared_future<std::vector<rclcpp::Parameter>>)> callback = nullptr);
  std::shared_future<std::vector<rcl_interfaces::msg::ParameterDescriptor>> describe_parameters(
      const std::vector<std::string>& names,
      std::function<void(std::shared_future<std::vector<rcl_interfaces::msg::ParameterDescriptor>>)>
          callback = nullptr);
  std::shared_future<std::vector<rclcpp::ParameterType>> get_parameter_types(
      const std::vector<std::string>& names,
      std::function<void(std::shared_future<std::vector<rclcpp::ParameterType>>)> callback =
          nullptr);
  std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>> set_parameters(
      const std::vector<rclcpp::Parameter>& parameters,
      std::function<void(std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>>)>
          callback = nullptr);
  std::shared_future<rcl_interfaces::msg::SetParametersResult> set_parameters_atomically(
      const std::vector<rclcpp::Parameter>& parameters,
      std::function<void(std::shared_future<rcl_interfaces::msg::SetParametersResult>)> callback =
          nullptr);
  std::shared_future<rcl_interfaces::msg::ListParametersResult> list_parameters(
      const std::vector<std::string>& prefixes, uint64_t depth,
      std::function<void(std::shared_future<rcl_interfaces::msg::ListParametersResult>)> callback =
          nullptr);
  std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>> delete_parameters(
      const std::vector<std::string>& parameters_names);
  std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>> load_parameters(
      const std::string& yaml_filename);
  std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>> load_parameters(
      const rclcpp::ParameterMap& parameter_map);

  template <typename CallbackT, typename AllocatorT = std::allocator<void>>
  typename rclcpp::Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(
      CallbackT&& callback, const rclcpp::QoS& qos = rclcpp::ParameterEventsQoS(),
      const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& options =
          rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>()) {
    return on_parameter_event(node_topics_interface_, std::forward<CallbackT>(callback), qos,
                              options);
  }

  template <typename CallbackT, typename NodeT, typename AllocatorT = std::allocator<void>>
  static typename rclcpp::Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr
  on_parameter_event(NodeT&& node, CallbackT&& callback,
                     const rclcpp::QoS& qos = rclcpp::ParameterEventsQoS(),
                     const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& options =
                         rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>()) {
    return rclcpp::create_subscription<rcl_interfaces::msg::ParameterEvent>(
        node, "/parameter_events", qos, std::forward<CallbackT>(callback), options);
  }

  bool service_is_ready() const;
  template <typename RepT = int64_t, typename RatioT = std::milli>
  bool wait_for_service(
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return wait_for_service_nanoseconds(
        std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

 protected:
  bool wait_for_service_nanoseconds(std::chrono::nanoseconds timeout);

 private:
  struct Clients;
  node_interfaces::NodeTopicsInterface::SharedPtr node_topics_interface_;
  std::shared_ptr<Clients> clients_;
  std::string remote_node_name_;
};

class SyncParametersClient {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(SyncParametersClient)

  template <typename NodeT>
  explicit SyncParametersClient(std::shared_ptr<NodeT> node,
                                const std::string& remote_node_name = "",
                                const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS())
      : SyncParametersClient(std::make_shared<rclcpp::executors::SingleThreadedExecutor>(),
                             node.get(), remote_node_name, qos_profile) {}
  template <typename NodeT>
  SyncParametersClient(rclcpp::Executor::SharedPtr executor, std::shared_ptr<NodeT> node,
                       const std::string& remote_node_name = "",
                       const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS())
      : SyncParametersClient(executor, node.get(), remote_node_name, qos_profile) {}
  template <typename NodeT>
  explicit SyncParametersClient(NodeT* node, const std::string& remote_node_name = "",
                                const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS())
      : SyncParametersClient(std::make_shared<rclcpp::executors::SingleThreadedExecutor>(), node,
                             remote_node_name, qos_profile) {}
  template <typename NodeT>
  SyncParametersClient(rclcpp::Executor::SharedPtr executor, NodeT* node,
                       const std::string& remote_node_name = "",
                       const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS())
      : SyncParametersClient(executor, node->get_node_base_interface(),
                             node->get_node_topics_interface(), node->get_node_graph_interface(),
                             node->get_node_services_interface(), remote_node_name, qos_profile) {}
  SyncParametersClient(
      rclcpp::Executor::SharedPtr executor,
      const node_interfaces::NodeBaseInterface::SharedPtr node_base_interface,
      const node_interfaces::NodeTopicsInterface::SharedPtr node_topics_interface,
      const node_interfaces::NodeGraphInterface::SharedPtr node_graph_interface,
      const node_interfaces::NodeServicesInterface::SharedPtr node_services_interface,
      const std::string& remote_node_name = "",
      const rclcpp::QoS& qos_profile = rclcpp::ParametersQoS())
      : executor_(std::move(executor)),
        node_base_interface_(node_base_interface),
        async_parameters_client_(std::make_shared<AsyncParametersClient>(
            node_base_interface, node_topics_interface, node_graph_interface,
            node_services_interface, remote_node_name, qos_profile)) {}

  template <typename RepT = int64_t, typename RatioT = std::milli>
  std::vector<rclcpp::Parameter> get_parameters(
      const std::vector<std::string>& parameter_names,
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return get(async_parameters_client_->get_parameters(parameter_names), timeout);
  }
  template <typename RepT = int64_t, typename RatioT = std::milli>
  std::vector<rcl_interfaces::msg::ParameterDescriptor> describe_parameters(
      const std::vector<std::string>& parameter_names,
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return get(async_parameters_client_->describe_parameters(parameter_names), timeout);
  }
  template <typename RepT = int64_t, typename RatioT = std::milli>
  std::vector<rclcpp::ParameterType> get_parameter_types(
      const std::vector<std::string>& parameter_names,
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return get(async_parameters_client_->get_parameter_types(parameter_names), timeout);
  }
  template <typename RepT = int64_t, typename RatioT = std::milli>
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(
      const std::vector<rclcpp::Parameter>& parameters,
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return get(async_parameters_client_->set_parameters(parameters), timeout);
  }
  template <typename RepT = int64_t, typename RatioT = std::milli>
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(
      const std::vector<rclcpp::Parameter>& parameters,
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return get(async_parameters_client_->set_parameters_atomically(parameters), timeout);
  }
  template <typename RepT = int64_t, typename RatioT = std::milli>
  rcl_interfaces::msg::ListParametersResult list_parameters(
      const std::vector<std::string>& parameter_prefixes, uint64_t depth,
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return get(async_parameters_client_->list_parameters(parameter_prefixes, depth), timeout);
  }
  template <typename RepT = int64_t, typename RatioT = std::milli>
  std::vector<rcl_interfaces::msg::SetParametersResult> delete_parameters(
      const std::vector<std::string>& parameters_names,
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return get(async_parameters_client_->delete_parameters(parameters_names), timeout);
  }
  template <typename RepT = int64_t, typename RatioT = std::milli>
  std::vector<rcl_interfaces::msg::SetParametersResult> load_parameters(
      const std::string& yaml_filename,
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return get(async_parameters_client_->load_parameters(yaml_filename), timeout);
  }

  bool has_parameter(const std::string& parameter_name);

  template <typename T>
  T get_parameter_impl(const std::string& parameter_name,
                       std::function<T()> parameter_not_found_handler) {
    const auto found = get_parameters({parameter_name});
    if (found.size() != 1 || found[0].get_type() == rclcpp::ParameterType::PARAMETER_NOT_SET) {
      return parameter_not_found_handler();
    }
    return static_cast<T>(found[0].template get_value<T>());
  }
  template <typename T>
  T get_parameter(const std::string& parameter_name, const T& default_value) {
    return get_parameter_impl(parameter_name,
                              std::function<T()>([&]() -> T { return default_value; }));
  }
  template <typename T>
  T get_parameter(const std::string& parameter_name) {
    return get_parameter_impl(
        parameter_name, std::function<T()>([&]() -> T {
          throw std::runtime_error("Parameter '" + parameter_name + "' is not set");
        }));
  }

  template <typename CallbackT>
  typename rclcpp::Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(
      CallbackT&& callback) {
    return async_parameters_client_->on_parameter_event(std::forward<CallbackT>(callback));
  }
  template <typename CallbackT, typename NodeT>
  static typename rclcpp::Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr
  on_parameter_event(NodeT&& node, CallbackT&& callback) {
    return AsyncParametersClient::on_parameter_event(node, std::forward<CallbackT>(callback));
  }
  bool service_is_ready() const { return async_parameters_client_->service_is_ready(); }
  template <typename RepT = int64_t, typename RatioT = std::milli>
  bool wait_for_service(
      std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1)) {
    return async_parameters_client_->wait_for_service(timeout);
  }

 private:
  /// Spins until the answer is there; an empty one after the timeout.
  template <typename ResultT, typename DurationT>
  ResultT get(const std::shared_future<ResultT>& future, DurationT timeout) {
    const auto code = rclcpp::executors::spin_node_until_future_complete(
        *executor_, node_base_interface_, future, timeout);
    return code == rclcpp::FutureReturnCode::SUCCESS ? future.get() : not_answered<ResultT>();
  }
  template <typename ResultT>
  static ResultT not_answered() {
    if constexpr (std::is_same_v<ResultT, rcl_interfaces::msg::SetParametersResult>) {
      throw std::runtime_error("Unable to get result of set parameters service call.");
    } else {
      return ResultT();
    }
  }

  rclcpp::Executor::SharedPtr executor_;
  const node_interfaces::NodeBaseInterface::SharedPtr node_base_interface_;
  AsyncParametersClient::SharedPtr async_parameters_client_;
};

}  // namespace rclcpp
