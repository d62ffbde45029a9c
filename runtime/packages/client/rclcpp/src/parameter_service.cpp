// The parameter services.
#include "rclcpp/parameter_service.hpp"

#include <string>

#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/create_service.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp {
namespace {

template <typename ServiceT>
using RequestPtr = std::shared_ptr<typename ServiceT::Request>;
template <typename ServiceT>
using ResponsePtr = std::shared_ptr<typename ServiceT::Response>;

void log_failure(const char* what, const std::exception& error) {
  RCLCPP_WARN(rclcpp::get_logger("rclcpp"), "Failed to %s: %s", what, error.what());
}

std::vector<rclcpp::Parameter> from_messages(
    const std::vector<rcl_interfaces::msg::Parameter>& messages) {
  std::vector<rclcpp::Parameter> parameters;
  for (const auto& message : messages) {
    parameters.push_back(rclcpp::Parameter::from_parameter_msg(message));
  }
  return parameters;
}

rcl_interfaces::msg::SetParametersResult failure(const char* reason) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = false;
  result.reason = reason;
  return result;
}

}  // namespace

ParameterService::ParameterService(
    const node_interfaces::NodeBaseInterface::SharedPtr& node_base,
    const node_interfaces::NodeServicesInterface::SharedPtr& node_services,
    node_interfaces::NodeParametersInterface* params, const rclcpp::QoS& qos_profile) {
  using rcl_interfaces::srv::DescribeParameters;
  using rcl_interfaces::srv::GetParameters;
  using rcl_interfaces::srv::GetParameterTypes;
  using rcl_interfaces::srv::ListParameters;
  using rcl_interfaces::srv::SetParameters;
  using rcl_interfaces::srv::SetParametersAtomically;

  const std::string prefix = std::string("~/");
  services_.push_back(create_service<GetParameters>(
      node_base, node_services, prefix + "get_parameters",
      [params](RequestPtr<GetParameters> request, ResponsePtr<GetParameters> response) {
        try {
          for (const rclcpp::Parameter& parameter : params->get_parameters(request->names)) {
            response->values.push_back(parameter.get_value_message());
          }
        } catch (const std::exception& error) {
          log_failure("get parameters", error);
        }
      },
      qos_profile, nullptr));
  services_.push_back(create_service<GetParameterTypes>(
      node_base, node_services, prefix + "get_parameter_types",
      [params](RequestPtr<GetParameterTypes> request, ResponsePtr<GetParameterTypes> response) {
        try {
          response->types = params->get_parameter_types(request->names);
        } catch (const std::exception& error) {
          log_failure("get parameter types", error);
        }
      },
      qos_profile, nullptr));
  services_.push_back(create_service<SetParameters>(
      node_base, node_services, prefix + "set_parameters",
      [params](RequestPtr<SetParameters> request, ResponsePtr<SetParameters> response) {
        // One by one: what follows a failure is still set.
        for (const auto& message : request->parameters) {
          try {
            response->results.push_back(params->set_parameters_atomically(
                {rclcpp::Parameter::from_parameter_msg(message)}));
          } catch (const std::exception& error) {
            log_failure("set parameter", error);
            response->results.push_back(failure(error.what()));
          }
        }
      },
      qos_profile, nullptr));
  services_.push_back(create_service<SetParametersAtomically>(
      node_base, node_services, prefix + "set_parameters_atomically",
      [params](RequestPtr<SetParametersAtomically> request,
               ResponsePtr<SetParametersAtomically> response) {
        try {
          response->result = params->set_parameters_atomically(from_messages(request->parameters));
        } catch (const std::exception& error) {
          log_failure("set parameters atomically", error);
          response->result = failure("One or more parameters were not declared before setting");
        }
      },
      qos_profile, nullptr));
  services_.push_back(create_service<DescribeParameters>(
      node_base, node_services, prefix + "describe_parameters",
      [params](RequestPtr<DescribeParameters> request, ResponsePtr<DescribeParameters> response) {
        try {
          response->descriptors = params->describe_parameters(request->names);
        } catch (const std::exception& error) {
          log_failure("describe parameters", error);
        }
      },
      qos_profile, nullptr));
  services_.push_back(create_service<ListParameters>(
      node_base, node_services, prefix + "list_parameters",
      [params](RequestPtr<ListParameters> request, ResponsePtr<ListParameters> response) {
        response->result = params->list_parameters(request->prefixes, request->depth);
      },
      qos_profile, nullptr));
}

}  // namespace rclcpp
