// Services of Gazebo that ROS may call.
#pragma once

#include <memory>

#include "bridge_entry.hpp"
#include "rclcpp/rclcpp.hpp"

namespace ros_gz_bridge {

/// Offers the service to ROS and passes requests on to Gazebo. Lives as long as what it returns.
/// Throws std::runtime_error when there is no such pair of types.
std::shared_ptr<void> relay_service(rclcpp::Node& node, const ServiceEntry& entry);

}  // namespace ros_gz_bridge
