// A leaf that sends a goal to an action server, and runs as long as the goal does.
#pragma once

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "action_msgs/msg/goal_status.hpp"
#include "behaviortree_cpp/action_node.h"
#include "behaviortree_cpp/json_export.h"
#include "nav2_behavior_tree/bt_utils.hpp"
#include "nav2_behavior_tree/detail/action_leaf.hpp"
#include "nav2_behavior_tree/json_utils.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

namespace nav2_behavior_tree {

using namespace std::chrono_literals;

template <class ActionT>
class BtActionNode : public detail::ActionLeaf<ActionT> {
  using Leaf = detail::ActionLeaf<ActionT>;
  using Client = rclcpp_action::Client<ActionT>;
  using GoalHandle = rclcpp_action::ClientGoalHandle<ActionT>;
  using GoalHandlePtr = typename GoalHandle::SharedPtr;
  using FutureGoalHandle = std::shared_future<GoalHandlePtr>;

 public:
  /// Throws std::runtime_error when the server does not come in time.
  BtActionNode(const std::string& xml_tag_name, const std::string& action_name,
               const BT::NodeConfiguration& conf)
      : Leaf(xml_tag_name, action_name, conf),
        cancel_timeout_(detail::timeout_of(*this, "cancel_timeout")) {}
  BtActionNode() = delete;
  ~BtActionNode() override = default;

  // For subclasses.

  /// Fills in `goal_`. Setting `should_send_goal_` to false fails.
  virtual void on_tick() {}
  /// While the goal runs; `feedback` is null when none came since. Setting `goal_updated_` sends
  /// `goal_` again.
  virtual void on_wait_for_result(std::shared_ptr<const typename ActionT::Feedback> /*feedback*/) {}
  virtual BT::NodeStatus on_success() { return BT::NodeStatus::SUCCESS; }
  virtual BT::NodeStatus on_aborted() { return BT::NodeStatus::FAILURE; }
  virtual BT::NodeStatus on_cancelled() { return BT::NodeStatus::SUCCESS; }

  BT::NodeStatus tick() override {
    if (!BT::isStatusActive(this->status()) && !begin()) return BT::NodeStatus::FAILURE;
    if (future_goal_handle_) {
      if (const auto waiting = wait_for_goal_handle()) return *waiting;
    }
    if (rclcpp::ok() && !goal_result_available_) {
      on_wait_for_result(feedback_);
      feedback_.reset();
      if (goal_updated_ && is_goal_live()) {
        goal_updated_ = false;
        send_new_goal();
        if (const auto waiting = wait_for_goal_handle()) return *waiting;
      }
      callback_group_executor_.spin_some();
      if (!goal_result_available_) return BT::NodeStatus::RUNNING;
    }
    const BT::NodeStatus answer = answer_of_result();
    goal_handle_.reset();
    return answer;
  }

  /// Cancels the goal when it runs.
  void halt() override {
    take_late_goal_handle();
    if (should_cancel_goal()) {
      const auto future_result = action_client_->async_get_result(goal_handle_);
      const auto future_cancel = action_client_->async_cancel_goal(goal_handle_);
      if (!this->is_ready_within(future_cancel, server_timeout_)) {
        RCLCPP_ERROR(node_->get_logger(), "Failed to cancel action server for %s",
                     action_name_.c_str());
      }
      if (!this->is_ready_within(future_result, cancel_timeout_)) {
        RCLCPP_ERROR(node_->get_logger(), "Failed to get result for %s in node halt!",
                     action_name_.c_str());
      }
      on_cancelled();
    }
    this->resetStatus();
  }

 protected:
  using Leaf::action_client_;
  using Leaf::action_name_;
  using Leaf::callback_group_executor_;
  using Leaf::max_timeout_;
  using Leaf::node_;
  using Leaf::server_timeout_;

  bool should_cancel_goal() {
    if (this->status() != BT::NodeStatus::RUNNING || !goal_handle_) return false;
    callback_group_executor_.spin_some();
    return is_goal_live();
  }

  void send_new_goal() {
    goal_result_available_ = false;
    typename Client::SendGoalOptions options;
    options.result_callback = [this](const typename GoalHandle::WrappedResult& result) {
      // A result that comes while a newer goal waits for its handle is that of an older one.
      if (future_goal_handle_ || !goal_handle_) return;
      if (goal_handle_->get_goal_id() != result.goal_id) return;
      goal_result_available_ = true;
      result_ = result;
      this->emitWakeUpSignal();
    };
    options.feedback_callback =
        [this](GoalHandlePtr, const std::shared_ptr<const typename ActionT::Feedback> feedback) {
          feedback_ = feedback;
          this->emitWakeUpSignal();
        };
    future_goal_handle_ =
        std::make_shared<FutureGoalHandle>(action_client_->async_send_goal(goal_, options));
    time_goal_sent_ = node_->now();
  }

  typename ActionT::Goal goal_;
  bool goal_updated_ = false;
  bool goal_result_available_ = false;
  GoalHandlePtr goal_handle_;
  typename GoalHandle::WrappedResult result_;
  std::shared_ptr<const typename ActionT::Feedback> feedback_;
  std::chrono::milliseconds cancel_timeout_;
  std::shared_ptr<FutureGoalHandle> future_goal_handle_;  ///< while the server has not answered
  rclcpp::Time time_goal_sent_;
  bool should_send_goal_ = true;

 private:
  bool begin() {
    should_send_goal_ = true;
    goal_ = typename ActionT::Goal();
    result_ = typename GoalHandle::WrappedResult();
    on_tick();
    this->setStatus(BT::NodeStatus::RUNNING);
    if (should_send_goal_) send_new_goal();
    return should_send_goal_;
  }

  /// Nothing once the server has accepted the goal.
  std::optional<BT::NodeStatus> wait_for_goal_handle() {
    auto elapsed = this->since(time_goal_sent_);
    if (elapsed < server_timeout_) {
      const auto timeout = std::min(server_timeout_ - elapsed, max_timeout_);
      if (this->is_ready_within(*future_goal_handle_, timeout)) {
        goal_handle_ = future_goal_handle_->get();
        future_goal_handle_.reset();
        if (goal_handle_) return std::nullopt;
        return BT::NodeStatus::FAILURE;  // rejected
      }
      if (!rclcpp::ok()) {
        future_goal_handle_.reset();
        return BT::NodeStatus::FAILURE;
      }
      elapsed += timeout;
    }
    if (elapsed < server_timeout_) return BT::NodeStatus::RUNNING;
    RCLCPP_WARN(node_->get_logger(),
                "Timed out while waiting for action server to acknowledge goal request for %s",
                action_name_.c_str());
    future_goal_handle_.reset();
    return BT::NodeStatus::FAILURE;
  }

  /// A goal that the server has not answered yet would go on when it is not cancelled, too.
  void take_late_goal_handle() {
    if (!future_goal_handle_ || this->status() != BT::NodeStatus::RUNNING) return;
    if (this->is_ready_within(*future_goal_handle_, server_timeout_)) {
      goal_handle_ = future_goal_handle_->get();
    }
    future_goal_handle_.reset();
  }

  bool is_goal_live() const {
    using action_msgs::msg::GoalStatus;
    const auto goal_status = goal_handle_->get_status();
    return goal_status == GoalStatus::STATUS_ACCEPTED ||
           goal_status == GoalStatus::STATUS_EXECUTING;
  }

  BT::NodeStatus answer_of_result() {
    switch (result_.code) {
      case rclcpp_action::ResultCode::SUCCEEDED:
        return on_success();
      case rclcpp_action::ResultCode::ABORTED:
        return on_aborted();
      case rclcpp_action::ResultCode::CANCELED:
        return on_cancelled();
      default:
        throw std::logic_error("BtActionNode::Tick: invalid status value");
    }
  }
};

}  // namespace nav2_behavior_tree
