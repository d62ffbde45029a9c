// All that trees are made of, and walks over them.
#pragma once

#include <functional>
#include <iosfwd>
#include <utility>
#include <vector>

#include "behaviortree_cpp/action_node.h"
#include "behaviortree_cpp/condition_node.h"
#include "behaviortree_cpp/control_node.h"
#include "behaviortree_cpp/controls.h"
#include "behaviortree_cpp/decorator_node.h"
#include "behaviortree_cpp/decorators.h"

namespace BT {

/// Each node before its children.
void applyRecursiveVisitor(const TreeNode* root, const std::function<void(const TreeNode*)>& visit);
void applyRecursiveVisitor(TreeNode* root, const std::function<void(TreeNode*)>& visit);

/// Names, indented by their depth.
void printTreeRecursively(const TreeNode* root, std::ostream& stream);
void printTreeRecursively(const TreeNode* root);

using SerializedTreeStatus = std::vector<std::pair<uint16_t, uint8_t>>;
void buildSerializedStatusSnapshot(const TreeNode* root, SerializedTreeStatus& snapshot);

}  // namespace BT
