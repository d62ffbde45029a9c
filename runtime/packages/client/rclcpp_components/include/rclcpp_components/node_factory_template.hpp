// Makes nodes of class NodeT, which takes NodeOptions.
#pragma once

#include <memory>

#include "rclcpp_components/node_factory.hpp"

namespace rclcpp_components {

template <typename NodeT>
class NodeFactoryTemplate : public NodeFactory {
 public:
  NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions& options) override {
    auto node = std::make_shared<NodeT>(options);
    return NodeInstanceWrapper(
        node, [node](const std::shared_ptr<void>&) { return node->get_node_base_interface(); });
  }
};

}  // namespace rclcpp_components
