// Nodes that look whether something is so.
#pragma once

#include <functional>
#include <string>

#include "behaviortree_cpp/leaf_node.h"

namespace BT {

class ConditionNode : public LeafNode {
 public:
  explicit ConditionNode(const std::string& name, const NodeConfig& config = {})
      : LeafNode(name, config) {}
  void halt() override { resetStatus(); }
  [[nodiscard]] NodeType type() const final { return NodeType::CONDITION; }
};

class SimpleConditionNode : public ConditionNode {
 public:
  using TickFunctor = std::function<NodeStatus(TreeNode&)>;

  SimpleConditionNode(const std::string& name, TickFunctor functor, const NodeConfig& config)
      : ConditionNode(name, config), functor_(std::move(functor)) {}

 private:
  NodeStatus tick() override { return functor_(*this); }

  TickFunctor functor_;
};

}  // namespace BT
