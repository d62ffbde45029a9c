// Nodes that do something.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <string>

#include "behaviortree_cpp/leaf_node.h"

namespace BT {

class ActionNodeBase : public LeafNode {
 public:
  explicit ActionNodeBase(const std::string& name, const NodeConfig& config = {})
      : LeafNode(name, config) {}
  [[nodiscard]] NodeType type() const final { return NodeType::ACTION; }
};

/// Is done within one tick, so it never says RUNNING.
class SyncActionNode : public ActionNodeBase {
 public:
  using ActionNodeBase::ActionNodeBase;
  NodeStatus executeTick() override;
  void halt() final { resetStatus(); }
};

class SimpleActionNode : public SyncActionNode {
 public:
  using TickFunctor = std::function<NodeStatus(TreeNode&)>;

  SimpleActionNode(const std::string& name, TickFunctor functor, const NodeConfig& config)
      : SyncActionNode(name, config), functor_(std::move(functor)) {}

 private:
  NodeStatus tick() override { return functor_(*this); }

  TickFunctor functor_;
};

/// Begins, goes on while it is RUNNING, and may be halted meanwhile.
class StatefulActionNode : public ActionNodeBase {
 public:
  using ActionNodeBase::ActionNodeBase;

  virtual NodeStatus onStart() = 0;
  virtual NodeStatus onRunning() = 0;
  virtual void onHalted() = 0;
  void halt() final;

 protected:
  NodeStatus tick() final;
  [[nodiscard]] bool isHaltRequested() const { return is_halted_; }

 private:
  bool is_halted_ = false;
};

/// Its tick() runs in a thread of its own. A program that uses it needs shared memory.
class ThreadedAction : public ActionNodeBase {
 public:
  using ActionNodeBase::ActionNodeBase;
  ~ThreadedAction() override {
    if (thread_.valid()) thread_.wait();
  }
  NodeStatus executeTick() override {
    if (status() == NodeStatus::IDLE) {
      is_halted_ = false;
      setStatus(NodeStatus::RUNNING);
      thread_ = std::async(std::launch::async, [this] { return tick(); });
    }
    if (thread_.valid() && thread_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      const NodeStatus done = thread_.get();
      if (!is_halted_) setStatus(done);
    }
    return status();
  }
  void halt() override {
    is_halted_ = true;
    if (thread_.valid()) thread_.wait();
    resetStatus();
  }

 protected:
  [[nodiscard]] bool isHaltRequested() const { return is_halted_; }

 private:
  std::atomic<bool> is_halted_ = false;
  std::future<NodeStatus> thread_;
};
using AsyncActionNode = ThreadedAction;

}  // namespace BT
