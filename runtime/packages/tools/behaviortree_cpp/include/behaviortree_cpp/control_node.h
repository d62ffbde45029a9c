// Nodes that choose which of their children are ticked.
#pragma once

#include <string>
#include <vector>

#include "behaviortree_cpp/tree_node.h"

namespace BT {

class ControlNode : public TreeNode {
 public:
  explicit ControlNode(const std::string& name, const NodeConfig& config = {})
      : TreeNode(name, config) {}

  /// The tree owns it.
  void addChild(TreeNode* child) { children_nodes_.push_back(child); }
  [[nodiscard]] std::size_t childrenCount() const { return children_nodes_.size(); }
  [[nodiscard]] const std::vector<TreeNode*>& children() const { return children_nodes_; }
  [[nodiscard]] const TreeNode* child(std::size_t index) const { return children_nodes_.at(index); }

  void halt() override;
  // A child that runs is halted; it is IDLE afterwards.
  void haltChildren() { haltChildren(0); }
  void haltChildren(std::size_t first);
  void haltChild(std::size_t index);
  void resetChildren() { haltChildren(0); }
  [[nodiscard]] NodeType type() const override { return NodeType::CONTROL; }

 protected:
  std::vector<TreeNode*> children_nodes_;
};

}  // namespace BT
