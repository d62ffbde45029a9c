// Nodes that choose which child is ticked.
#include <string>

#include "behaviortree_cpp/control_node.h"
#include "nodes/registration.hpp"

namespace nav2_behavior_tree {
namespace {

using BT::ControlNode;
using BT::NodeStatus;

/// Children in turn, with those before the running one ticked again each time.
class PipelineSequence : public ControlNode {
 public:
  using ControlNode::ControlNode;
  static BT::PortsList providedPorts() { return {}; }

  void halt() override {
    ControlNode::halt();
    reached_ = 0;
  }

 private:
  NodeStatus tick() override {
    size_t skipped = 0;
    for (size_t i = 0; i < children_nodes_.size(); ++i) {
      const NodeStatus answer = children_nodes_[i]->executeTick();
      if (answer == NodeStatus::FAILURE) return end(answer);
      if (answer == NodeStatus::SKIPPED) ++skipped;
      if (answer == NodeStatus::RUNNING && i >= reached_) {
        reached_ = i;
        return answer;
      }
      if (answer == NodeStatus::IDLE) {
        throw std::runtime_error("Invalid node status. Received status IDLE from child " +
                                 children_nodes_[i]->name());
      }
    }
    return end(skipped == children_nodes_.size() ? NodeStatus::SKIPPED : NodeStatus::SUCCESS);
  }

  NodeStatus end(NodeStatus answer) {
    haltChildren();
    reached_ = 0;
    return answer;
  }

  size_t reached_ = 0;  ///< the farthest child that ran
};

/// The first child; after its failure the second, and then the first again.
class RecoveryNode : public ControlNode {
 public:
  using ControlNode::ControlNode;
  static BT::PortsList providedPorts() {
    return {BT::InputPort<int>("number_of_retries", 1, "How often the first child is tried again")};
  }

  void halt() override {
    ControlNode::halt();
    retries_ = 0;
    recovers_ = false;
  }

 private:
  NodeStatus tick() override {
    if (children_nodes_.size() != 2) {
      throw BT::BehaviorTreeException("Recovery Node '" + name() + "' must only have 2 children.");
    }
    int most = 1;
    getInput("number_of_retries", most);
    setStatus(NodeStatus::RUNNING);
    while (retries_ <= most) {
      const NodeStatus answer = children_nodes_[recovers_ ? 1 : 0]->executeTick();
      if (answer == NodeStatus::RUNNING) return answer;
      if (answer == NodeStatus::IDLE) {
        throw BT::LogicError("A child node must never return IDLE");
      }
      if (recovers_) {
        if (answer == NodeStatus::SKIPPED) {
          haltChild(1);
          recovers_ = false;
          return NodeStatus::FAILURE;
        }
        if (answer == NodeStatus::FAILURE) return end(answer);
        haltChild(1);
        ++retries_;
        recovers_ = false;
      } else {
        if (answer != NodeStatus::FAILURE || retries_ == most) return end(answer);
        haltChild(0);
        recovers_ = true;
      }
    }
    return end(NodeStatus::FAILURE);
  }

  NodeStatus end(NodeStatus answer) {
    halt();
    return answer;
  }

  int retries_ = 0;
  bool recovers_ = false;  ///< the second child is the next
};

/// One child at a time, the next one at each time, until all have failed.
class RoundRobin : public ControlNode {
 public:
  using ControlNode::ControlNode;
  static BT::PortsList providedPorts() { return {}; }

  void halt() override {
    ControlNode::halt();
    current_ = 0;
    failed_ = 0;
  }

 private:
  NodeStatus tick() override {
    const size_t count = children_nodes_.size();
    size_t skipped = 0;
    setStatus(NodeStatus::RUNNING);
    while (failed_ + skipped < count) {
      const NodeStatus answer = children_nodes_[current_]->executeTick();
      if (answer == NodeStatus::RUNNING) return answer;
      if (answer == NodeStatus::IDLE) throw BT::LogicError("Invalid status return from BT node");
      current_ = (current_ + 1) % count;
      if (answer == NodeStatus::SUCCESS) {
        failed_ = 0;
        haltChildren();
        return answer;
      }
      ++(answer == NodeStatus::FAILURE ? failed_ : skipped);
    }
    halt();
    return skipped == count ? NodeStatus::SKIPPED : NodeStatus::FAILURE;
  }

  size_t current_ = 0;
  size_t failed_ = 0;  ///< in a row
};

const NodeLibrary pipeline("libnav2_pipeline_sequence_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<PipelineSequence>("PipelineSequence");
});
const NodeLibrary recovery("libnav2_recovery_node_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<RecoveryNode>("RecoveryNode");
});
const NodeLibrary round_robin("libnav2_round_robin_node_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<RoundRobin>("RoundRobin");
});

}  // namespace
}  // namespace nav2_behavior_tree
