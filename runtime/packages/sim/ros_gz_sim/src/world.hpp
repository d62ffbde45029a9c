// The world of a running Gazebo Sim, and calls of its services.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace ros_gz_sim {

/// The name of the world that Gazebo runs: waits for it, and says so every five seconds. Nothing
/// when the program ends before.
std::optional<std::string> name_of_world(const rclcpp::Node::SharedPtr& node);

/// The answer of a service of Gazebo, `/world/NAME/create`: waits for the service, and says so
/// every five seconds. Null when the program ends before.
template <typename Service>
typename Service::Response::SharedPtr answer_of(const rclcpp::Node::SharedPtr& node,
                                                const std::string& service,
                                                typename Service::Request::SharedPtr request);

}  // namespace ros_gz_sim
