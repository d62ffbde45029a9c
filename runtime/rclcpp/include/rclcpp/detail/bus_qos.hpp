// QoS as the bus takes it, with the system's defaults filled in.
#pragma once

#include "rclcpp/qos.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace detail {

/// Replaces "system default" by what this middleware does.
rclcpp::QoS resolve_qos(const rclcpp::QoS& qos);
ros2wasm::EndpointQos to_bus(const rclcpp::QoS& resolved);
rclcpp::QoS from_bus(const ros2wasm::EndpointQos& qos);

}  // namespace detail
}  // namespace rclcpp
