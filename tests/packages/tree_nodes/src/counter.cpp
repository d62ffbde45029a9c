#include "tree_nodes/counter.hpp"

#include "behaviortree_cpp_v3/bt_factory.h"

namespace tree_nodes {

Counter::Counter(const std::string& name, const BT::NodeConfiguration& config)
    : BT::SyncActionNode(name, config) {}

BT::PortsList Counter::providedPorts() {
  return {BT::BidirectionalPort<int>("count")};
}

BT::NodeStatus Counter::tick() {
  const int count = getInput<int>("count").value_or(0);
  setOutput("count", count + 1);
  return BT::NodeStatus::SUCCESS;
}

}  // namespace tree_nodes

BT_REGISTER_NODES(factory) {
  factory.registerNodeType<tree_nodes::Counter>("Counter");
}
