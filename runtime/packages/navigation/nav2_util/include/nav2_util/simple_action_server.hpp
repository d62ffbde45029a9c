// An action server with one goal at a time: the work is a function that runs in a thread, and a
// newer goal waits until that function takes it. Programs that have one are linked with threads.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "nav2_util/node_thread.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

namespace nav2_util {

/// The log of an action server: lines with the name of the action. Compiled once for all actions.
class ActionServerLog {
 protected:
  ActionServerLog(rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging_interface,
                  const std::string& action_name)
      : node_logging_interface_(std::move(node_logging_interface)), action_name_(action_name) {}

  void info_msg(const char* msg) const;
  void debug_msg(const char* msg) const;
  void error_msg(const char* msg) const;
  void warn_msg(const char* msg) const;

  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging_interface_;
  std::string action_name_;
};

template <typename ActionT>
class SimpleActionServer : protected ActionServerLog {
  using GoalHandle = rclcpp_action::ServerGoalHandle<ActionT>;
  using GoalPtr = std::shared_ptr<const typename ActionT::Goal>;
  using ResultPtr = std::shared_ptr<typename ActionT::Result>;
  using Lock = std::lock_guard<std::recursive_mutex>;

 public:
  using ExecuteCallback = std::function<void()>;
  /// Runs when a goal ended without succeeded_current() or terminate_*() of the function itself.
  using CompletionCallback = std::function<void()>;

  /// `server_timeout`: how long deactivate() waits for the function before it ends the goals.
  /// `spin_thread`: the server has a thread for its requests. `realtime` has no effect in a
  /// browser.
  template <typename NodeT>
  explicit SimpleActionServer(
      NodeT node, const std::string& action_name, ExecuteCallback execute_callback,
      CompletionCallback completion_callback = nullptr,
      std::chrono::milliseconds server_timeout = std::chrono::milliseconds(500),
      bool spin_thread = false,
      const rcl_action_server_options_t& options = rcl_action_server_get_default_options(),
      const bool realtime = false)
      : SimpleActionServer(node->get_node_base_interface(), node->get_node_clock_interface(),
                           node->get_node_logging_interface(), node->get_node_waitables_interface(),
                           action_name, execute_callback, completion_callback, server_timeout,
                           spin_thread, options, realtime) {}

  explicit SimpleActionServer(
      rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base_interface,
      rclcpp::node_interfaces::NodeClockInterface::SharedPtr node_clock_interface,
      rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging_interface,
      rclcpp::node_interfaces::NodeWaitablesInterface::SharedPtr node_waitables_interface,
      const std::string& action_name, ExecuteCallback execute_callback,
      CompletionCallback completion_callback = nullptr,
      std::chrono::milliseconds server_timeout = std::chrono::milliseconds(500),
      bool spin_thread = false,
      const rcl_action_server_options_t& options = rcl_action_server_get_default_options(),
      const bool realtime = false)
      : ActionServerLog(node_logging_interface, action_name),
        node_base_interface_(node_base_interface),
        node_clock_interface_(node_clock_interface),
        node_waitables_interface_(node_waitables_interface),
        execute_callback_(std::move(execute_callback)),
        completion_callback_(std::move(completion_callback)),
        use_realtime_prioritization_(realtime),
        server_timeout_(server_timeout),
        spin_thread_(spin_thread) {
    if (spin_thread_) {
      callback_group_ = node_base_interface_->create_callback_group(
          rclcpp::CallbackGroupType::MutuallyExclusive, false);
    }
    action_server_ = rclcpp_action::create_server<ActionT>(
        node_base_interface_, node_clock_interface_, node_logging_interface_,
        node_waitables_interface_, action_name_,
        [this](const rclcpp_action::GoalUUID& uuid, GoalPtr goal) {
          return handle_goal(uuid, goal);
        },
        [this](const std::shared_ptr<GoalHandle> handle) { return handle_cancel(handle); },
        [this](const std::shared_ptr<GoalHandle> handle) { handle_accepted(handle); }, options,
        callback_group_);
    if (spin_thread_) {
      executor_ = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
      executor_->add_callback_group(callback_group_, node_base_interface_);
      executor_thread_ = std::make_unique<nav2_util::NodeThread>(executor_);
    }
  }

  rclcpp_action::GoalResponse handle_goal(const rclcpp_action::GoalUUID&, GoalPtr) {
    const Lock lock(update_mutex_);
    if (!server_active_) {
      RCLCPP_INFO(node_logging_interface_->get_logger(),
                  "Action server is inactive. Rejecting the goal.");
      return rclcpp_action::GoalResponse::REJECT;
    }
    debug_msg("Received request for goal acceptance");
    return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
  }

  rclcpp_action::CancelResponse handle_cancel(const std::shared_ptr<GoalHandle> handle) {
    const Lock lock(update_mutex_);
    if (!handle->is_active()) {
      warn_msg(
          "Received request for goal cancellation,"
          "but the handle is inactive, so reject the request");
      return rclcpp_action::CancelResponse::REJECT;
    }
    debug_msg("Received request for goal cancellation");
    return rclcpp_action::CancelResponse::ACCEPT;
  }

  void setSoftRealTimePriority() {
    if (use_realtime_prioritization_) nav2_util::setSoftRealTimePriority();
  }

  void handle_accepted(const std::shared_ptr<GoalHandle> handle) {
    const Lock lock(update_mutex_);
    debug_msg("Receiving a new goal");
    if (is_active(current_handle_) || is_working_) {
      debug_msg("An older goal is active, moving the new goal to a pending slot.");
      if (is_active(pending_handle_)) {
        debug_msg(
            "The pending slot is occupied."
            " The previous pending goal will be terminated and replaced.");
        terminate(pending_handle_);
      }
      pending_handle_ = handle;
      preempt_requested_ = true;
      return;
    }
    if (is_active(pending_handle_)) {
      error_msg("Forgot to handle a preemption. Terminating the pending goal.");
      terminate(pending_handle_);
      preempt_requested_ = false;
    }
    current_handle_ = handle;
    is_working_ = true;
    debug_msg("Executing goal asynchronously.");
    execution_future_ = std::async(std::launch::async, [this] {
      setSoftRealTimePriority();
      work();
    });
  }

  /// Runs the function until no goal is left.
  void work() {
    while (goes_on()) {
      debug_msg("Executing the goal...");
      try {
        execute_callback_();
      } catch (const std::exception& error) {
        RCLCPP_ERROR(node_logging_interface_->get_logger(),
                     "Action server failed while executing action callback: \"%s\"", error.what());
        const Lock lock(update_mutex_);
        terminate_all();
        complete();
        is_working_ = false;
        return;
      }
      debug_msg("Blocking processing of new goal handles.");
      const Lock lock(update_mutex_);
      if (stop_execution_) {
        warn_msg("Stopping the thread per request.");
        terminate_all();
        complete();
        is_working_ = false;
        break;
      }
      if (is_active(current_handle_)) {
        warn_msg("Current goal was not completed successfully.");
        terminate(current_handle_);
        complete();
      }
      if (!is_active(pending_handle_)) {
        debug_msg("Done processing available goals.");
        is_working_ = false;
        break;
      }
      debug_msg("Executing a pending handle on the existing thread.");
      accept_pending_goal();
    }
    debug_msg("Worker thread done.");
  }

  void activate() {
    const Lock lock(update_mutex_);
    server_active_ = true;
    stop_execution_ = false;
  }

  /// Returns when the function has ended.
  void deactivate() {
    debug_msg("Deactivating...");
    {
      const Lock lock(update_mutex_);
      server_active_ = false;
      stop_execution_ = true;
    }
    if (!execution_future_.valid()) return;
    if (is_running()) {
      warn_msg(
          "Requested to deactivate server but goal is still executing."
          " Should check if action server is running before deactivating.");
    }
    const auto start = std::chrono::steady_clock::now();
    while (execution_future_.wait_for(std::chrono::milliseconds(100)) !=
           std::future_status::ready) {
      info_msg("Waiting for async process to finish.");
      if (std::chrono::steady_clock::now() - start >= server_timeout_) {
        terminate_all();
        complete();
        error_msg("Action callback is still running and missed deadline to stop");
      }
    }
    debug_msg("Deactivation completed.");
  }

  bool is_running() {
    const Lock lock(update_mutex_);
    return execution_future_.valid() &&
           execution_future_.wait_for(std::chrono::milliseconds(0)) == std::future_status::timeout;
  }

  bool is_server_active() {
    const Lock lock(update_mutex_);
    return server_active_;
  }

  bool is_preempt_requested() const {
    const Lock lock(update_mutex_);
    return preempt_requested_;
  }

  /// Ends the current goal in favour of the one that waits.
  const GoalPtr accept_pending_goal() {
    const Lock lock(update_mutex_);
    if (!is_active(pending_handle_)) {
      error_msg("Attempting to get pending goal when not available");
      return GoalPtr();
    }
    if (is_active(current_handle_) && current_handle_ != pending_handle_) {
      debug_msg("Cancelling the previous goal");
      current_handle_->abort(empty_result());
    }
    current_handle_ = pending_handle_;
    pending_handle_.reset();
    preempt_requested_ = false;
    debug_msg("Preempted goal");
    return current_handle_->get_goal();
  }

  void terminate_pending_goal() {
    const Lock lock(update_mutex_);
    if (!is_active(pending_handle_)) {
      error_msg("Attempting to terminate pending goal when not available");
      return;
    }
    terminate(pending_handle_);
    preempt_requested_ = false;
    debug_msg("Pending goal terminated");
  }

  const GoalPtr get_current_goal() const {
    const Lock lock(update_mutex_);
    if (!is_active(current_handle_)) {
      error_msg("A goal is not available or has reached a final state");
      return GoalPtr();
    }
    return current_handle_->get_goal();
  }

  const rclcpp_action::GoalUUID get_current_goal_id() const {
    const Lock lock(update_mutex_);
    if (!is_active(current_handle_)) {
      error_msg("A goal is not available or has reached a final state");
      return rclcpp_action::GoalUUID();
    }
    return current_handle_->get_goal_id();
  }

  const GoalPtr get_pending_goal() const {
    const Lock lock(update_mutex_);
    if (!is_active(pending_handle_)) {
      error_msg("Attempting to get pending goal when not available");
      return GoalPtr();
    }
    return pending_handle_->get_goal();
  }

  /// Whether the goal that waits is to be canceled, or the current one when none waits.
  bool is_cancel_requested() const {
    const Lock lock(update_mutex_);
    if (current_handle_ == nullptr) {
      error_msg("Checking for cancel but current goal is not available");
      return false;
    }
    return (pending_handle_ ? pending_handle_ : current_handle_)->is_canceling();
  }

  void terminate_all(ResultPtr result = std::make_shared<typename ActionT::Result>()) {
    const Lock lock(update_mutex_);
    terminate(current_handle_, result);
    terminate(pending_handle_, result);
    preempt_requested_ = false;
  }

  void terminate_current(ResultPtr result = std::make_shared<typename ActionT::Result>()) {
    const Lock lock(update_mutex_);
    terminate(current_handle_, result);
  }

  void succeeded_current(ResultPtr result = std::make_shared<typename ActionT::Result>()) {
    const Lock lock(update_mutex_);
    if (is_active(current_handle_)) {
      debug_msg("Setting succeed on current goal.");
      current_handle_->succeed(result);
      current_handle_.reset();
    }
  }

  void publish_feedback(std::shared_ptr<typename ActionT::Feedback> feedback) {
    const Lock lock(update_mutex_);
    if (!is_active(current_handle_)) {
      error_msg("Trying to publish feedback when the current goal handle is not active");
      return;
    }
    current_handle_->publish_feedback(feedback);
  }

 protected:
  /// Whether the thread looks at another goal. A goal that comes after a no starts a new thread.
  bool goes_on() {
    const Lock lock(update_mutex_);
    is_working_ = rclcpp::ok() && !stop_execution_ && is_active(current_handle_);
    return is_working_;
  }

  ResultPtr empty_result() const { return std::make_shared<typename ActionT::Result>(); }

  bool is_active(const std::shared_ptr<GoalHandle>& handle) const {
    return handle != nullptr && handle->is_active();
  }

  void complete() {
    if (completion_callback_) completion_callback_();
  }

  /// Canceled when the client asked for that, otherwise aborted.
  void terminate(std::shared_ptr<GoalHandle>& handle,
                 ResultPtr result = std::make_shared<typename ActionT::Result>()) {
    const Lock lock(update_mutex_);
    if (!is_active(handle)) return;
    if (handle->is_canceling()) {
      info_msg("Client requested to cancel the goal. Cancelling.");
      handle->canceled(result);
    } else {
      warn_msg("Aborting handle.");
      handle->abort(result);
    }
    handle.reset();
  }

  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base_interface_;
  rclcpp::node_interfaces::NodeClockInterface::SharedPtr node_clock_interface_;
  rclcpp::node_interfaces::NodeWaitablesInterface::SharedPtr node_waitables_interface_;
  ExecuteCallback execute_callback_;
  CompletionCallback completion_callback_;
  std::future<void> execution_future_;
  bool stop_execution_{false};
  bool is_working_{false};  // the thread takes a pending goal when it is done
  bool use_realtime_prioritization_{false};
  mutable std::recursive_mutex update_mutex_;
  bool server_active_{false};
  bool preempt_requested_{false};
  std::chrono::milliseconds server_timeout_;
  std::shared_ptr<GoalHandle> current_handle_;
  std::shared_ptr<GoalHandle> pending_handle_;
  typename rclcpp_action::Server<ActionT>::SharedPtr action_server_;
  bool spin_thread_;
  rclcpp::CallbackGroup::SharedPtr callback_group_{nullptr};
  rclcpp::executors::SingleThreadedExecutor::SharedPtr executor_;
  std::unique_ptr<nav2_util::NodeThread> executor_thread_;
};

}  // namespace nav2_util
