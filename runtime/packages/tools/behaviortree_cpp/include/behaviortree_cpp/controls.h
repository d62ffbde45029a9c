// The control nodes that every factory knows.
#pragma once

#include <string>

#include "behaviortree_cpp/control_node.h"

namespace BT {

/// Children in turn until one fails (Sequence) or succeeds (Fallback), going on where it was.
class InTurn : public ControlNode {
 public:
  enum class After { kRestart, kStay };  ///< where it begins once a child has ended it

  InTurn(const std::string& name, NodeStatus goes_on, After after)
      : ControlNode(name), goes_on_(goes_on), after_(after) {}
  void halt() override;

 private:
  NodeStatus tick() override;

  NodeStatus goes_on_;
  After after_;
  std::size_t current_ = 0;
  std::size_t skipped_ = 0;
};

class SequenceNode : public InTurn {
 public:
  explicit SequenceNode(const std::string& name, bool /*make_async*/ = false)
      : InTurn(name, NodeStatus::SUCCESS, After::kRestart) {}
};
class SequenceWithMemory : public InTurn {
 public:
  explicit SequenceWithMemory(const std::string& name)
      : InTurn(name, NodeStatus::SUCCESS, After::kStay) {}
};
using SequenceStarNode = SequenceWithMemory;
class FallbackNode : public InTurn {
 public:
  explicit FallbackNode(const std::string& name, bool /*make_async*/ = false)
      : InTurn(name, NodeStatus::FAILURE, After::kRestart) {}
};

/// As Sequence and Fallback, but from the first child at each tick.
class Reactive : public ControlNode {
 public:
  /// `throws`: whether it is an error that another child runs than before.
  Reactive(const std::string& name, NodeStatus goes_on, const bool& throws)
      : ControlNode(name), goes_on_(goes_on), throws_(throws) {}
  void halt() override;

 private:
  NodeStatus tick() override;

  NodeStatus goes_on_;
  const bool& throws_;
  const TreeNode* running_ = nullptr;  ///< the child that ran first since the node began
};
class ReactiveSequence : public Reactive {
 public:
  explicit ReactiveSequence(const std::string& name)
      : Reactive(name, NodeStatus::SUCCESS, throws) {}
  static void EnableException(bool enable) { throws = enable; }

 private:
  static inline bool throws = false;
};
class ReactiveFallback : public Reactive {
 public:
  explicit ReactiveFallback(const std::string& name)
      : Reactive(name, NodeStatus::FAILURE, throws) {}
  static void EnableException(bool enable) { throws = enable; }

 private:
  static inline bool throws = false;
};

/// All children at each tick, until so many have succeeded or failed. Thresholds below 0 count from
/// all children; version 3 calls them *_threshold, version 4 *_count.
class ParallelNode : public ControlNode {
 public:
  ParallelNode(const std::string& name, const NodeConfig& config) : ControlNode(name, config) {}
  static PortsList providedPorts();
  void halt() override;

 private:
  NodeStatus tick() override;
  [[nodiscard]] int threshold(const std::string& of, int otherwise) const;
  NodeStatus done(NodeStatus status);

  std::vector<NodeStatus> answers_;  ///< of each child, IDLE while it has none
};

/// A condition, what is done then, and what else.
class IfThenElseNode : public ControlNode {
 public:
  explicit IfThenElseNode(const std::string& name) : ControlNode(name) {}
  void halt() override;

 private:
  NodeStatus tick() override;

  std::size_t branch_ = 0;  ///< 0 while the condition is asked
};

/// The same, with the condition asked at each tick.
class WhileDoElseNode : public ControlNode {
 public:
  explicit WhileDoElseNode(const std::string& name) : ControlNode(name) {}

 private:
  NodeStatus tick() override;
};

/// The child whose case is the value of `variable`, else the last one.
class AnySwitch : public ControlNode {
 public:
  AnySwitch(const std::string& name, const NodeConfig& config, std::size_t cases)
      : ControlNode(name, config), cases_(cases) {}
  static PortsList ports(std::size_t cases);
  void halt() override;

 private:
  NodeStatus tick() override;

  std::size_t cases_;
  std::size_t running_ = kNone;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
};
template <std::size_t NUM_CASES>
class SwitchNode : public AnySwitch {
 public:
  SwitchNode(const std::string& name, const NodeConfig& config)
      : AnySwitch(name, config, NUM_CASES) {}
  static PortsList providedPorts() { return ports(NUM_CASES); }
};

}  // namespace BT
