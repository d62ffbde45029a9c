// A goal at its server: what the executing code holds.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "rclcpp_action/goal_state.hpp"
#include "rclcpp_action/types.hpp"

namespace rclcpp_action {

template <typename ActionT>
class Server;

template <typename ActionT>
class ServerGoalHandle {
 public:
  using Result = typename ActionT::Result;
  using ResultResponse = typename ActionT::Impl::GetResultService::Response;
  using FeedbackMessage = typename ActionT::Impl::FeedbackMessage;

  /// A goal that is let go before it ended counts as cancelled.
  virtual ~ServerGoalHandle() {
    if (state_->try_canceling()) {
      state_->canceled();
      auto response = std::make_shared<ResultResponse>();
      response->status = GoalStatus::STATUS_CANCELED;
      on_terminal_state_(uuid_, response);
    }
  }

  bool is_canceling() const { return state_->status() == GoalStatus::STATUS_CANCELING; }
  bool is_active() const { return state_->is_active(); }
  bool is_executing() const { return state_->status() == GoalStatus::STATUS_EXECUTING; }

  void publish_feedback(std::shared_ptr<typename ActionT::Feedback> feedback_msg) {
    auto message = std::make_shared<FeedbackMessage>();
    message->goal_id.uuid = uuid_;
    message->feedback = *feedback_msg;
    publish_feedback_(message);
  }
  /// These end the goal. They throw RCLError when its state does not allow it.
  void abort(typename Result::SharedPtr result_msg) {
    state_->abort();
    finish(GoalStatus::STATUS_ABORTED, *result_msg);
  }
  void succeed(typename Result::SharedPtr result_msg) {
    state_->succeed();
    finish(GoalStatus::STATUS_SUCCEEDED, *result_msg);
  }
  void canceled(typename Result::SharedPtr result_msg) {
    state_->canceled();
    finish(GoalStatus::STATUS_CANCELED, *result_msg);
  }
  /// For a goal that was accepted and deferred.
  void execute() {
    state_->execute();
    on_executing_(uuid_);
  }
  const std::shared_ptr<const typename ActionT::Goal> get_goal() const { return goal_; }
  const GoalUUID& get_goal_id() const { return uuid_; }

 private:
  friend class Server<ActionT>;
  using OnTerminalState = std::function<void(const GoalUUID&, std::shared_ptr<ResultResponse>)>;
  using OnExecuting = std::function<void(const GoalUUID&)>;
  using PublishFeedback = std::function<void(std::shared_ptr<FeedbackMessage>)>;

  ServerGoalHandle(std::shared_ptr<GoalState> state, GoalUUID uuid,
                   std::shared_ptr<const typename ActionT::Goal> goal,
                   OnTerminalState on_terminal_state, OnExecuting on_executing,
                   PublishFeedback publish_feedback)
      : state_(std::move(state)),
        goal_(std::move(goal)),
        uuid_(uuid),
        on_terminal_state_(std::move(on_terminal_state)),
        on_executing_(std::move(on_executing)),
        publish_feedback_(std::move(publish_feedback)) {}

  void finish(int8_t status, const Result& result) {
    auto response = std::make_shared<ResultResponse>();
    response->status = status;
    response->result = result;
    on_terminal_state_(uuid_, response);
  }

  std::shared_ptr<GoalState> state_;
  const std::shared_ptr<const typename ActionT::Goal> goal_;
  const GoalUUID uuid_;
  OnTerminalState on_terminal_state_;
  OnExecuting on_executing_;
  PublishFeedback publish_feedback_;
};

}  // namespace rclcpp_action
