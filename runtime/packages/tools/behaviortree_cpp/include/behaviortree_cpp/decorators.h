// The decorators and the plain actions that every factory knows.
#pragma once

#include <chrono>
#include <string>

#include "behaviortree_cpp/action_node.h"
#include "behaviortree_cpp/decorator_node.h"

namespace BT {

/// Other answers for success and failure.
class Answering : public DecoratorNode {
 public:
  Answering(const std::string& name, NodeStatus success, NodeStatus failure)
      : DecoratorNode(name), success_(success), failure_(failure) {}

 private:
  NodeStatus tick() override;

  NodeStatus success_;
  NodeStatus failure_;
};
class InverterNode : public Answering {
 public:
  explicit InverterNode(const std::string& name)
      : Answering(name, NodeStatus::FAILURE, NodeStatus::SUCCESS) {}
};
class ForceSuccessNode : public Answering {
 public:
  explicit ForceSuccessNode(const std::string& name)
      : Answering(name, NodeStatus::SUCCESS, NodeStatus::SUCCESS) {}
};
class ForceFailureNode : public Answering {
 public:
  explicit ForceFailureNode(const std::string& name)
      : Answering(name, NodeStatus::FAILURE, NodeStatus::FAILURE) {}
};
class KeepRunningUntilFailureNode : public Answering {
 public:
  explicit KeepRunningUntilFailureNode(const std::string& name)
      : Answering(name, NodeStatus::RUNNING, NodeStatus::FAILURE) {}
};

/// The child again and again, while it gives an answer, so many times at most; -1 is without end.
class Again : public DecoratorNode {
 public:
  Again(const std::string& name, const NodeConfig& config, NodeStatus goes_on, std::string port)
      : DecoratorNode(name, config), goes_on_(goes_on), port_(std::move(port)) {}
  void halt() override;

 private:
  NodeStatus tick() override;

  NodeStatus goes_on_;
  std::string port_;
  int done_ = 0;
};
class RepeatNode : public Again {
 public:
  RepeatNode(const std::string& name, const NodeConfig& config)
      : Again(name, config, NodeStatus::SUCCESS, "num_cycles") {}
  static PortsList providedPorts() {
    return {InputPort<int>("num_cycles", "how many times; -1 is without end")};
  }
};
class RetryNode : public Again {
 public:
  RetryNode(const std::string& name, const NodeConfig& config)
      : Again(name, config, NodeStatus::FAILURE, "num_attempts") {}
  static PortsList providedPorts() {
    return {InputPort<int>("num_attempts", "how many times; -1 is without end")};
  }
};

/// The child begins later, by the clock, looked at when it is ticked.
class DelayNode : public DecoratorNode {
 public:
  DelayNode(const std::string& name, const NodeConfig& config) : DecoratorNode(name, config) {}
  static PortsList providedPorts() {
    return {InputPort<unsigned>("delay_msec", "milliseconds before the child is ticked")};
  }
  void halt() override;

 private:
  NodeStatus tick() override;

  bool has_begun_ = false;
  bool is_over_ = false;
  std::chrono::steady_clock::time_point until_;
};

/// A child that takes longer is halted, which is a failure.
class TimeoutNode : public DecoratorNode {
 public:
  TimeoutNode(const std::string& name, const NodeConfig& config) : DecoratorNode(name, config) {}
  static PortsList providedPorts() {
    return {InputPort<unsigned>("msec", "milliseconds that the child may take")};
  }
  void halt() override;

 private:
  NodeStatus tick() override;

  bool has_begun_ = false;
  std::chrono::steady_clock::time_point until_;
};

/// The child once; its answer, or SKIPPED, ever after.
class RunOnceNode : public DecoratorNode {
 public:
  RunOnceNode(const std::string& name, const NodeConfig& config) : DecoratorNode(name, config) {}
  static PortsList providedPorts() {
    return {InputPort<bool>("then_skip", true, "SKIPPED once it is done, else its answer")};
  }

 private:
  NodeStatus tick() override;

  NodeStatus answer_ = NodeStatus::IDLE;
};

/// The root of a tree that is used in another one.
class SubTreeNode : public DecoratorNode {
 public:
  explicit SubTreeNode(const std::string& name, const NodeConfig& config = {})
      : DecoratorNode(name, config) {}
  [[nodiscard]] NodeType type() const final { return NodeType::SUBTREE; }

 private:
  NodeStatus tick() override;
};

/// Writes a text to the blackboard.
class SetBlackboardNode : public SyncActionNode {
 public:
  SetBlackboardNode(const std::string& name, const NodeConfig& config)
      : SyncActionNode(name, config) {}
  static PortsList providedPorts() {
    return {InputPort("value", "what is written"), BidirectionalPort("output_key", "where")};
  }

 private:
  NodeStatus tick() override;
};

}  // namespace BT
