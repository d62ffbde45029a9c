// The states of a goal at its server, and which follow which.
#pragma once

#include <cstdint>
#include <mutex>

#include "rclcpp_action/types.hpp"

namespace rclcpp_action {

/// Thread safe. The setters throw RCLError when the state does not allow the change.
class GoalState {
 public:
  int8_t status() const;
  bool is_active() const;
  bool is_cancelable() const;
  void execute();
  void cancel_goal();
  void succeed();
  void abort();
  void canceled();
  /// Leads an active goal into CANCELING; false when it is over.
  bool try_canceling() noexcept;

 private:
  enum class Event { execute, cancel_goal, succeed, abort, canceled };
  void change(Event event);
  static const char* event_name(Event event);
  static int8_t next(int8_t status, Event event);

  mutable std::mutex mutex_;
  int8_t status_ = GoalStatus::STATUS_ACCEPTED;
};

}  // namespace rclcpp_action
