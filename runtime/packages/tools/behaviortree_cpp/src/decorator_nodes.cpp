// The decorators that every factory knows; see decorators.h.
#include "behaviortree_cpp/decorators.h"

namespace BT {
namespace {

using Clock = std::chrono::steady_clock;

template <typename T>
T asked(const TreeNode& node, const std::string& port) {
  T value{};
  if (const Result read = node.getInput(port, value); !read) {
    throw RuntimeError("Missing parameter [" + port + "] in " + node.registrationName() + ": " +
                       read.error());
  }
  return value;
}

}  // namespace

NodeStatus Answering::tick() {
  setStatus(NodeStatus::RUNNING);
  const NodeStatus answer = child_node_->executeTick();
  if (isStatusCompleted(answer)) resetChild();
  if (answer == NodeStatus::SUCCESS) return success_;
  if (answer == NodeStatus::FAILURE) return failure_;
  return answer;
}

NodeStatus Again::tick() {
  const int most = asked<int>(*this, port_);
  setStatus(NodeStatus::RUNNING);
  while (most == -1 || done_ < most) {
    const NodeStatus answer = child_node_->executeTick();
    if (answer == NodeStatus::RUNNING) return answer;
    resetChild();
    if (answer == NodeStatus::SKIPPED) return answer;
    if (answer != goes_on_) {
      done_ = 0;
      return answer;
    }
    ++done_;
  }
  done_ = 0;
  return goes_on_;
}

void Again::halt() {
  done_ = 0;
  DecoratorNode::halt();
}

NodeStatus DelayNode::tick() {
  if (!has_begun_) {
    has_begun_ = true;
    is_over_ = false;
    until_ = Clock::now() + std::chrono::milliseconds(asked<unsigned>(*this, "delay_msec"));
    setStatus(NodeStatus::RUNNING);
  }
  is_over_ = is_over_ || Clock::now() >= until_;
  if (!is_over_) return NodeStatus::RUNNING;
  const NodeStatus answer = child_node_->executeTick();
  if (answer != NodeStatus::RUNNING) {
    has_begun_ = false;
    resetChild();
  }
  return answer;
}

void DelayNode::halt() {
  has_begun_ = false;
  DecoratorNode::halt();
}

NodeStatus TimeoutNode::tick() {
  if (!has_begun_) {
    has_begun_ = true;
    until_ = Clock::now() + std::chrono::milliseconds(asked<unsigned>(*this, "msec"));
    setStatus(NodeStatus::RUNNING);
  } else if (Clock::now() >= until_) {
    has_begun_ = false;
    resetChild();
    return NodeStatus::FAILURE;
  }
  const NodeStatus answer = child_node_->executeTick();
  if (answer != NodeStatus::RUNNING) {
    has_begun_ = false;
    resetChild();
  }
  return answer;
}

void TimeoutNode::halt() {
  has_begun_ = false;
  DecoratorNode::halt();
}

NodeStatus RunOnceNode::tick() {
  if (answer_ != NodeStatus::IDLE) {
    return getInput<bool>("then_skip").value_or(true) ? NodeStatus::SKIPPED : answer_;
  }
  setStatus(NodeStatus::RUNNING);
  const NodeStatus answer = child_node_->executeTick();
  if (isStatusCompleted(answer)) {
    answer_ = answer;
    resetChild();
  }
  return answer;
}

NodeStatus SubTreeNode::tick() {
  setStatus(NodeStatus::RUNNING);
  const NodeStatus answer = child_node_->executeTick();
  if (isStatusCompleted(answer)) resetChild();
  return answer;
}

NodeStatus SetBlackboardNode::tick() {
  const auto key = getInput<std::string>("output_key");
  const std::string raw(getRawPortValue("output_key"));
  const std::string entry =
      isBlackboardPointer(raw) ? std::string(stripBlackboardPointer(raw)) : key.value_or(raw);
  Any value;
  if (const Result read = getInput("value", value); !read) throw RuntimeError(read.error());
  config().blackboard->set(entry, value);
  return NodeStatus::SUCCESS;
}

}  // namespace BT
