// QoS as the bus takes it, with the system's defaults filled in.
#pragma once

#include <string>

#include "rclcpp/qos.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace detail {

/// Replaces "system default" by what this middleware does.
rclcpp::QoS resolve_qos(const rclcpp::QoS& qos);
/// The same for an endpoint of a topic: "best available" becomes what fits all the other side's
/// endpoints that are there now, with the highest level of service.
rclcpp::QoS resolve_publisher_qos(const rclcpp::QoS& qos, const std::string& topic);
rclcpp::QoS resolve_subscription_qos(const rclcpp::QoS& qos, const std::string& topic);
ros2wasm::EndpointQos to_bus(const rclcpp::QoS& resolved);
rclcpp::QoS from_bus(const ros2wasm::EndpointQos& qos);

}  // namespace detail
}  // namespace rclcpp
