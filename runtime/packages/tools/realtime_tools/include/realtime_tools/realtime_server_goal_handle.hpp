// A goal of an action that a control loop ends, and that a timer reports to its client.
#pragma once

#include <exception>
#include <memory>
#include <mutex>
#include <utility>

#include "rclcpp/logging.hpp"
#include "rclcpp_action/server_goal_handle.hpp"

namespace realtime_tools {

template <class Action>
class RealtimeServerGoalHandle {
 public:
  using ResultSharedPtr = typename Action::Result::SharedPtr;
  using FeedbackSharedPtr = typename Action::Feedback::SharedPtr;

  std::shared_ptr<rclcpp_action::ServerGoalHandle<Action>> gh_;
  ResultSharedPtr preallocated_result_;
  FeedbackSharedPtr preallocated_feedback_;

  explicit RealtimeServerGoalHandle(
      const std::shared_ptr<rclcpp_action::ServerGoalHandle<Action>>& gh,
      const ResultSharedPtr& preallocated_result = nullptr,
      const FeedbackSharedPtr& preallocated_feedback = nullptr,
      const rclcpp::Logger& logger = rclcpp::get_logger("realtime_tools"))
      : gh_(gh),
        preallocated_result_(preallocated_result ? preallocated_result
                                                 : std::make_shared<typename Action::Result>()),
        preallocated_feedback_(preallocated_feedback
                                   ? preallocated_feedback
                                   : std::make_shared<typename Action::Feedback>()),
        logger_(logger) {}

  /// Each notes how the goal ends; the first one counts.
  void setAborted(ResultSharedPtr result = nullptr) { end(End::kAborted, std::move(result)); }
  void setCanceled(ResultSharedPtr result = nullptr) { end(End::kCanceled, std::move(result)); }
  void setSucceeded(ResultSharedPtr result = nullptr) { end(End::kSucceeded, std::move(result)); }

  void setFeedback(FeedbackSharedPtr feedback = nullptr) {
    const std::lock_guard<std::mutex> lock(mutex_);
    feedback_ = std::move(feedback);
  }
  void execute() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!gh_->is_executing() && end_ == End::kNone) gh_->execute();
  }
  bool valid() { return nullptr != gh_.get(); }

  /// Tells the client what has been noted. Called by a timer.
  void runNonRealtime() {
    if (!valid()) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    try {
      report();
    } catch (const std::exception& error) {
      RCLCPP_ERROR(logger_, "%s", error.what());
    }
  }

 private:
  enum class End { kNone, kAborted, kCanceled, kSucceeded };

  void end(End how, ResultSharedPtr result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (end_ != End::kNone) return;
    end_ = how;
    result_ = result ? std::move(result) : preallocated_result_;
  }

  void report() {
    if (feedback_ && gh_->is_executing()) gh_->publish_feedback(feedback_);
    feedback_.reset();
    if (!gh_->is_active()) return;
    // A goal that is to be cancelled is cancelled, however it ends.
    if (end_ == End::kCanceled || (end_ != End::kNone && gh_->is_canceling())) {
      if (gh_->is_canceling()) gh_->canceled(result_);
    } else if (end_ == End::kAborted) {
      gh_->abort(result_);
    } else if (end_ == End::kSucceeded) {
      gh_->succeed(result_);
    }
  }

  rclcpp::Logger logger_;
  std::mutex mutex_;
  End end_ = End::kNone;
  ResultSharedPtr result_;
  FeedbackSharedPtr feedback_;
};

}  // namespace realtime_tools
