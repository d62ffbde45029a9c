// Nodes with one child, whose answer they change.
#pragma once

#include <functional>
#include <string>

#include "behaviortree_cpp/tree_node.h"

namespace BT {

class DecoratorNode : public TreeNode {
 public:
  explicit DecoratorNode(const std::string& name, const NodeConfig& config = {})
      : TreeNode(name, config) {}

  /// The tree owns it. A second one is a BehaviorTreeException.
  void setChild(TreeNode* child);
  [[nodiscard]] const TreeNode* child() const { return child_node_; }
  [[nodiscard]] TreeNode* child() { return child_node_; }

  void halt() override;
  void haltChild() { resetChild(); }
  void resetChild();
  NodeStatus executeTick() override;
  [[nodiscard]] NodeType type() const override { return NodeType::DECORATOR; }

 protected:
  TreeNode* child_node_ = nullptr;
};

class SimpleDecoratorNode : public DecoratorNode {
 public:
  using TickFunctor = std::function<NodeStatus(NodeStatus, TreeNode&)>;

  SimpleDecoratorNode(const std::string& name, TickFunctor functor, const NodeConfig& config)
      : DecoratorNode(name, config), functor_(std::move(functor)) {}

 private:
  NodeStatus tick() override { return functor_(child_node_->executeTick(), *this); }

  TickFunctor functor_;
};

}  // namespace BT
