// Makes a node of some class.
#pragma once

#include "rclcpp/node_options.hpp"
#include "rclcpp_components/node_instance_wrapper.hpp"

namespace rclcpp_components {

class NodeFactory {
 public:
  NodeFactory() = default;
  virtual ~NodeFactory() = default;
  virtual NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions& options) = 0;
};

}  // namespace rclcpp_components
