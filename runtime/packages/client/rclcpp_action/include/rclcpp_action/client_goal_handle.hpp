// A goal as its client sees it.
#pragma once

#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <utility>

#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_action/exceptions.hpp"
#include "rclcpp_action/types.hpp"

namespace rclcpp_action {

template <typename ActionT>
class Client;

template <typename ActionT>
class ClientGoalHandle {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(ClientGoalHandle)

  struct WrappedResult {
    GoalUUID goal_id;
    ResultCode code;
    typename ActionT::Result::SharedPtr result;
  };

  using Feedback = typename ActionT::Feedback;
  using Result = typename ActionT::Result;
  using FeedbackCallback =
      std::function<void(std::shared_ptr<ClientGoalHandle>, const std::shared_ptr<const Feedback>)>;
  using ResultCallback = std::function<void(const WrappedResult& result)>;

  virtual ~ClientGoalHandle() = default;

  const GoalUUID& get_goal_id() const { return info_.goal_id.uuid; }
  rclcpp::Time get_goal_stamp() const { return info_.stamp; }
  int8_t get_status() {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return status_;
  }
  bool is_feedback_aware() {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return static_cast<bool>(feedback_callback_);
  }
  bool is_result_aware() {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return is_result_aware_;
  }

 private:
  friend class Client<ActionT>;

  ClientGoalHandle(const GoalInfo& info, FeedbackCallback feedback_callback,
                   ResultCallback result_callback)
      : info_(info),
        result_future_(result_promise_.get_future()),
        feedback_callback_(std::move(feedback_callback)),
        result_callback_(std::move(result_callback)) {}

  void set_callbacks(FeedbackCallback feedback, ResultCallback result) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    feedback_callback_ = std::move(feedback);
    result_callback_ = std::move(result);
  }
  void set_result_callback(ResultCallback callback) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    result_callback_ = std::move(callback);
  }
  /// Returns the value from before.
  bool set_result_awareness(bool awareness) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return std::exchange(is_result_aware_, awareness);
  }
  void set_status(int8_t status) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    status_ = status;
  }
  void call_feedback_callback(const std::shared_ptr<ClientGoalHandle>& self,
                              const std::shared_ptr<const Feedback>& feedback) {
    FeedbackCallback callback;
    {
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      callback = feedback_callback_;
    }
    if (callback) {
      callback(self, feedback);
    }
  }
  void set_result(const WrappedResult& result) {
    ResultCallback callback;
    {
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      if (is_finished_) {
        return;
      }
      is_finished_ = true;
      status_ = static_cast<int8_t>(result.code);
      callback = result_callback_;
    }
    result_promise_.set_value(result);
    if (callback) {
      callback(result);
    }
  }
  /// Ends all waits for the result with this error: the result will not come.
  void invalidate(const exceptions::UnawareGoalHandleError& error) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    if (is_finished_) {
      return;
    }
    is_finished_ = true;
    is_result_aware_ = false;
    status_ = GoalStatus::STATUS_UNKNOWN;
    result_promise_.set_exception(std::make_exception_ptr(error));
  }

  GoalInfo info_;
  bool is_result_aware_ = false;
  bool is_finished_ = false;
  std::promise<WrappedResult> result_promise_;
  std::shared_future<WrappedResult> result_future_;
  FeedbackCallback feedback_callback_;
  ResultCallback result_callback_;
  int8_t status_ = GoalStatus::STATUS_ACCEPTED;
  std::recursive_mutex mutex_;
};

}  // namespace rclcpp_action
