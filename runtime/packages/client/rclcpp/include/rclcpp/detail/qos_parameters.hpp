// QoS overrides: parameters `qos_overrides.<topic>.<publisher|subscription>[_id].<policy>`.
#pragma once

#include <string>

#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/qos_overriding_options.hpp"

namespace rclcpp {
namespace detail {

enum class QosEntity { publisher, subscription };

/// Declares the read-only parameters of the policies that may be overridden and returns the QoS
/// that follows from their values. Throws InvalidQosOverridesException when the validation
/// callback refuses it, std::invalid_argument for a value that is not a policy.
rclcpp::QoS declare_qos_parameters(const rclcpp::QosOverridingOptions& options,
                                   node_interfaces::NodeParametersInterface& parameters,
                                   const std::string& topic_name, const rclcpp::QoS& default_qos,
                                   QosEntity entity);

}  // namespace detail
}  // namespace rclcpp
