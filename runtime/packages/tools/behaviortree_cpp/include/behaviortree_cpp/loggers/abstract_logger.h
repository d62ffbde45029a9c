// Base class of loggers: they are called at each status change of a tree's nodes.
#pragma once

#include <vector>

#include "behaviortree_cpp/bt_factory.h"

namespace BT {

enum class TimestampType { absolute, relative };

class StatusChangeLogger {
 public:
  explicit StatusChangeLogger(TreeNode* root) {
    begin_ = std::chrono::high_resolution_clock::now();
    applyRecursiveVisitor(root, [this](TreeNode* node) {
      subscriptions_.push_back(node->subscribeToStatusChange(
          [this](TimePoint now, const TreeNode& of, NodeStatus before, NodeStatus status) {
            if (!enabled_ || (status == NodeStatus::IDLE && !shows_idle_)) return;
            callback(type_ == TimestampType::absolute ? now.time_since_epoch() : now - begin_, of,
                     before, status);
          }));
    });
  }
  virtual ~StatusChangeLogger() = default;
  StatusChangeLogger(const StatusChangeLogger&) = delete;
  StatusChangeLogger& operator=(const StatusChangeLogger&) = delete;

  virtual void callback(Duration timestamp, const TreeNode& node, NodeStatus before,
                        NodeStatus status) = 0;
  virtual void flush() = 0;
  void setEnabled(bool enabled) { enabled_ = enabled; }
  [[nodiscard]] bool enabled() const { return enabled_; }
  void setTimestampType(TimestampType type) { type_ = type; }
  void enableTransitionToIdle(bool enable) { shows_idle_ = enable; }
  [[nodiscard]] bool showsTransitionToIdle() const { return shows_idle_; }

 private:
  bool enabled_ = true;
  bool shows_idle_ = true;
  TimestampType type_ = TimestampType::absolute;
  TimePoint begin_;
  std::vector<TreeNode::StatusChangeSubscriber> subscriptions_;
};

}  // namespace BT
