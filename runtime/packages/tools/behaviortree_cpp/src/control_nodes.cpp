// The control nodes that every factory knows; see controls.h.
#include <algorithm>

#include "behaviortree_cpp/controls.h"

namespace BT {
namespace {

NodeStatus ask(TreeNode& child, const ControlNode& of) {
  const NodeStatus answer = child.executeTick();
  if (answer == NodeStatus::IDLE) {
    throw LogicError("[" + of.name() + "]: A children should not return IDLE");
  }
  return answer;
}

}  // namespace

NodeStatus InTurn::tick() {
  if (!isStatusActive(status())) skipped_ = 0;
  setStatus(NodeStatus::RUNNING);
  for (; current_ < childrenCount(); ++current_) {
    const NodeStatus answer = ask(*children_nodes_[current_], *this);
    if (answer == NodeStatus::RUNNING) return answer;
    if (answer == NodeStatus::SKIPPED) {
      ++skipped_;
      continue;
    }
    if (answer == goes_on_) continue;
    if (after_ == After::kStay) {
      haltChildren(current_);
    } else {
      resetChildren();
      current_ = 0;
    }
    return answer;
  }
  const bool all_skipped = skipped_ == childrenCount() && skipped_ > 0;
  resetChildren();
  current_ = 0;
  skipped_ = 0;
  return all_skipped ? NodeStatus::SKIPPED : goes_on_;
}

void InTurn::halt() {
  if (after_ == After::kRestart) current_ = 0;
  ControlNode::halt();
}

void Reactive::halt() {
  running_ = nullptr;
  ControlNode::halt();
}

NodeStatus Reactive::tick() {
  if (status() == NodeStatus::IDLE) running_ = nullptr;
  setStatus(NodeStatus::RUNNING);
  std::size_t skipped = 0;
  for (std::size_t i = 0; i < childrenCount(); ++i) {
    const NodeStatus answer = ask(*children_nodes_[i], *this);
    if (answer == NodeStatus::RUNNING) {
      // The others begin anew when they are asked next.
      for (std::size_t other = 0; other < childrenCount(); ++other) {
        if (other == i) continue;
        if (children_nodes_[other]->status() == NodeStatus::RUNNING) haltChild(other);
        children_nodes_[other]->resetStatus();
      }
      if (running_ == nullptr) running_ = children_nodes_[i];
      if (throws_ && running_ != children_nodes_[i]) {
        throw LogicError("[" + registrationName() + "]: only a single child can return RUNNING.\n" +
                         "This throw can be disabled with " + registrationName() +
                         "::EnableException(false)");
      }
      return answer;
    }
    if (answer == NodeStatus::SKIPPED) {
      ++skipped;
    } else if (answer != goes_on_) {
      resetChildren();
      return answer;
    }
  }
  resetChildren();
  return skipped == childrenCount() && skipped > 0 ? NodeStatus::SKIPPED : goes_on_;
}

PortsList ParallelNode::providedPorts() {
  return {InputPort<int>("success_count", "children that succeed for it to succeed"),
          InputPort<int>("failure_count", "children that fail for it to fail"),
          InputPort<int>("success_threshold", "the same, in trees of version 3"),
          InputPort<int>("failure_threshold", "the same, in trees of version 3")};
}

int ParallelNode::threshold(const std::string& of, int otherwise) const {
  int asked = otherwise;
  for (const char* ending : {"_count", "_threshold"}) {
    if (config().input_ports.count(of + ending) == 0) continue;
    if (const Result read = getInput(of + ending, asked); !read) {
      throw RuntimeError("Missing parameter [" + of + ending +
                         "] in ParallelNode: " + read.error());
    }
  }
  const int count = static_cast<int>(childrenCount());
  return asked < 0 ? std::max(count + asked + 1, 0) : asked;
}

NodeStatus ParallelNode::tick() {
  const int count = static_cast<int>(childrenCount());
  const int success = threshold("success", -1);
  const int failure = threshold("failure", 1);
  if (count < success) {
    throw LogicError("Number of children is less than threshold. Can never succeed.");
  }
  if (count < failure) {
    throw LogicError("Number of children is less than threshold. Can never fail.");
  }
  answers_.resize(childrenCount(), NodeStatus::IDLE);
  setStatus(NodeStatus::RUNNING);
  const auto so_many = [this](NodeStatus answer) {
    return static_cast<int>(std::count(answers_.begin(), answers_.end(), answer));
  };
  for (std::size_t i = 0; i < childrenCount(); ++i) {
    if (answers_[i] != NodeStatus::IDLE) continue;
    const NodeStatus answer = ask(*children_nodes_[i], *this);
    if (answer != NodeStatus::RUNNING) answers_[i] = answer;
    const int succeeded = so_many(NodeStatus::SUCCESS);
    const int failed = so_many(NodeStatus::FAILURE);
    if (succeeded >= success ||
        (success < 0 && succeeded + so_many(NodeStatus::SKIPPED) >= success)) {
      return done(NodeStatus::SUCCESS);
    }
    if (count - failed < success || failed >= failure) return done(NodeStatus::FAILURE);
  }
  return so_many(NodeStatus::SKIPPED) == count ? done(NodeStatus::SKIPPED) : NodeStatus::RUNNING;
}

NodeStatus ParallelNode::done(NodeStatus status) {
  answers_.clear();
  resetChildren();
  return status;
}

void ParallelNode::halt() {
  answers_.clear();
  ControlNode::halt();
}

NodeStatus IfThenElseNode::tick() {
  const std::size_t count = childrenCount();
  if (count != 2 && count != 3) {
    throw std::logic_error("IfThenElseNode must have either 2 or 3 children");
  }
  setStatus(NodeStatus::RUNNING);
  if (branch_ == 0) {
    const NodeStatus condition = ask(*children_nodes_[0], *this);
    if (condition == NodeStatus::RUNNING) return condition;
    if (condition == NodeStatus::FAILURE && count == 2) {
      resetChildren();
      return condition;
    }
    branch_ = condition == NodeStatus::FAILURE ? 2 : 1;
  }
  const NodeStatus answer = ask(*children_nodes_[branch_], *this);
  if (answer == NodeStatus::RUNNING) return answer;
  resetChildren();
  branch_ = 0;
  return answer;
}

void IfThenElseNode::halt() {
  branch_ = 0;
  ControlNode::halt();
}

NodeStatus WhileDoElseNode::tick() {
  const std::size_t count = childrenCount();
  if (count != 2 && count != 3) {
    throw std::logic_error("WhileDoElseNode must have either 2 or 3 children");
  }
  setStatus(NodeStatus::RUNNING);
  const NodeStatus condition = ask(*children_nodes_[0], *this);
  if (condition == NodeStatus::RUNNING) return condition;
  const std::size_t chosen = condition == NodeStatus::FAILURE ? 2 : 1;
  if (chosen >= count) {
    resetChildren();
    return NodeStatus::FAILURE;
  }
  if (count == 3 && children_nodes_[3 - chosen]->status() == NodeStatus::RUNNING) {
    haltChild(3 - chosen);
  }
  const NodeStatus answer = ask(*children_nodes_[chosen], *this);
  if (answer != NodeStatus::RUNNING) resetChildren();
  return answer;
}

PortsList AnySwitch::ports(std::size_t cases) {
  PortsList list{InputPort<std::string>("variable", "what is compared")};
  for (std::size_t i = 1; i <= cases; ++i) {
    list.insert(InputPort<std::string>("case_" + std::to_string(i)));
  }
  return list;
}

NodeStatus AnySwitch::tick() {
  if (childrenCount() != cases_ + 1) {
    throw LogicError("Wrong number of children in SwitchNode; must be (num_cases + default)");
  }
  std::size_t chosen = cases_;
  std::string variable;
  if (getInput("variable", variable)) {
    for (std::size_t i = cases_; i-- > 0;) {
      if (getInput<std::string>("case_" + std::to_string(i + 1)).value_or("") == variable) {
        chosen = i;
      }
    }
  }
  setStatus(NodeStatus::RUNNING);
  if (running_ != kNone && running_ != chosen) haltChild(running_);
  const NodeStatus answer = ask(*children_nodes_[chosen], *this);
  running_ = answer == NodeStatus::RUNNING ? chosen : kNone;
  if (answer != NodeStatus::RUNNING) resetChildren();
  return answer;
}

void AnySwitch::halt() {
  running_ = kNone;
  ControlNode::halt();
}

}  // namespace BT
