// Two interfaces that stand for their node where something is created.
#pragma once

#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"

namespace tf2_ros {
namespace detail {

struct Interfaces {
  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr parameters;
  rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr topics;

  const auto& get_node_parameters_interface() const { return parameters; }
  const auto& get_node_topics_interface() const { return topics; }
};

}  // namespace detail
}  // namespace tf2_ros
