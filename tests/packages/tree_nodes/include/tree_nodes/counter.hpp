// Counts on the blackboard; a library of nodes that another package's program loads.
#pragma once

#include <string>

#include "behaviortree_cpp_v3/action_node.h"

namespace tree_nodes {

class Counter : public BT::SyncActionNode {
 public:
  Counter(const std::string& name, const BT::NodeConfiguration& config);
  static BT::PortsList providedPorts();
  BT::NodeStatus tick() override;
};

}  // namespace tree_nodes
