// A node's parameters, for real.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/publisher.hpp"

namespace rclcpp {

class ParameterService;

namespace node_interfaces {

struct ParameterInfo {
  rclcpp::ParameterValue value;
  rcl_interfaces::msg::ParameterDescriptor descriptor;
};

/// The part of a node's options that is about its parameters.
struct NodeParametersOptions {
  std::vector<rclcpp::Parameter> parameter_overrides;
  bool start_parameter_services = true;
  bool start_parameter_event_publisher = true;
  rclcpp::QoS parameter_event_qos = rclcpp::ParameterEventsQoS();
  rclcpp::PublisherOptionsBase parameter_event_publisher_options;
  bool allow_undeclared_parameters = false;
  bool automatically_declare_parameters_from_overrides = false;
};

class NodeParameters : public NodeParametersInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeParameters)

  NodeParameters(const NodeBaseInterface::SharedPtr& node_base,
                 const NodeLoggingInterface::SharedPtr& node_logging,
                 const NodeTopicsInterface::SharedPtr& node_topics,
                 const NodeServicesInterface::SharedPtr& node_services,
                 const NodeClockInterface::SharedPtr& node_clock,
                 const NodeParametersOptions& options);
  ~NodeParameters() override;

  const rclcpp::ParameterValue& declare_parameter(
      const std::string& name, const rclcpp::ParameterValue& default_value,
      const rcl_interfaces::msg::ParameterDescriptor& parameter_descriptor,
      bool ignore_override) override;
  const rclcpp::ParameterValue& declare_parameter(
      const std::string& name, rclcpp::ParameterType type,
      const rcl_interfaces::msg::ParameterDescriptor& parameter_descriptor,
      bool ignore_override) override;
  void undeclare_parameter(const std::string& name) override;
  bool has_parameter(const std::string& name) const override;
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(
      const std::vector<rclcpp::Parameter>& parameters) override;
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(
      const std::vector<rclcpp::Parameter>& parameters) override;
  std::vector<rclcpp::Parameter> get_parameters(
      const std::vector<std::string>& names) const override;
  rclcpp::Parameter get_parameter(const std::string& name) const override;
  bool get_parameter(const std::string& name, rclcpp::Parameter& parameter) const override;
  bool get_parameters_by_prefix(
      const std::string& prefix,
      std::map<std::string, rclcpp::Parameter>& parameters) const override;
  std::vector<rcl_interfaces::msg::ParameterDescriptor> describe_parameters(
      const std::vector<std::string>& names) const override;
  std::vector<uint8_t> get_parameter_types(const std::vector<std::string>& names) const override;
  rcl_interfaces::msg::ListParametersResult list_parameters(
      const std::vector<std::string>& prefixes, uint64_t depth) const override;

  PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(
      PreSetParametersCallbackType callback) override;
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
      OnSetParametersCallbackType callback) override;
  PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
      PostSetParametersCallbackType callback) override;
  void remove_pre_set_parameters_callback(
      const PreSetParametersCallbackHandle* const handler) override;
  void remove_on_set_parameters_callback(
      const OnSetParametersCallbackHandle* const handler) override;
  void remove_post_set_parameters_callback(
      const PostSetParametersCallbackHandle* const handler) override;
  const std::map<std::string, rclcpp::ParameterValue>& get_parameter_overrides() const override {
    return overrides_;
  }

 private:
  RCLCPP_DISABLE_COPY(NodeParameters)
  using Infos = std::map<std::string, ParameterInfo>;
  using SetResult = rcl_interfaces::msg::SetParametersResult;

  const rclcpp::ParameterValue& declare(const std::string& name, rclcpp::ParameterType type,
                                        const rclcpp::ParameterValue& default_value,
                                        rcl_interfaces::msg::ParameterDescriptor descriptor,
                                        bool ignore_override);
  SetResult check(const std::vector<rclcpp::Parameter>& parameters, const Infos& infos) const;
  SetResult ask_callbacks(const std::vector<rclcpp::Parameter>& parameters);
  void tell_callbacks(const std::vector<rclcpp::Parameter>& parameters);
  void publish(rcl_interfaces::msg::ParameterEvent event);

  mutable std::recursive_mutex mutex_;
  bool changing_ = false;
  Infos parameters_;
  std::map<std::string, rclcpp::ParameterValue> overrides_;
  const bool allow_undeclared_;
  std::string node_name_;
  NodeClockInterface::SharedPtr node_clock_;
  rclcpp::Publisher<rcl_interfaces::msg::ParameterEvent>::SharedPtr events_publisher_;
  std::shared_ptr<ParameterService> parameter_service_;
  std::list<PreSetParametersCallbackHandle::WeakPtr> pre_set_callbacks_;
  std::list<OnSetParametersCallbackHandle::WeakPtr> on_set_callbacks_;
  std::list<PostSetParametersCallbackHandle::WeakPtr> post_set_callbacks_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
