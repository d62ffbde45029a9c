// Actions: feedback, result, rejection, cancelling.
#include "checks.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using CancelGoal = action_msgs::srv::CancelGoal;
using Fibonacci = example_interfaces::action::Fibonacci;
using ServerHandle = rclcpp_action::ServerGoalHandle<Fibonacci>;
using Client = rclcpp_action::Client<Fibonacci>;
using namespace std::chrono_literals;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  Checks checks("actions");
  auto node = std::make_shared<rclcpp::Node>("actions_node");
  std::shared_ptr<ServerHandle> active;
  int steps = 0;
  int asked = 0;
  auto server = rclcpp_action::create_server<Fibonacci>(
      node, "fibonacci",
      [](const rclcpp_action::GoalUUID&, std::shared_ptr<const Fibonacci::Goal> goal) {
        return goal->order > 100 ? rclcpp_action::GoalResponse::REJECT
                                 : rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [&](const std::shared_ptr<ServerHandle>) {
        ++asked;
        return rclcpp_action::CancelResponse::ACCEPT;
      },
      [&](const std::shared_ptr<ServerHandle> handle) {
        active = handle;
        steps = 0;
      });
  auto work = node->create_wall_timer(1ms, [&] {
    if (!active) {
      return;
    }
    auto result = std::make_shared<Fibonacci::Result>();
    if (active->is_canceling()) {
      active->canceled(result);
      active.reset();
      return;
    }
    auto feedback = std::make_shared<Fibonacci::Feedback>();
    feedback->sequence = {steps};
    active->publish_feedback(feedback);
    if (++steps == active->get_goal()->order) {
      result->sequence = {0, 1, 1};
      active->succeed(result);
      active.reset();
    }
  });
  auto client = rclcpp_action::create_client<Fibonacci>(node, "fibonacci");
  CHECK(client->wait_for_action_server(1s));

  int feedbacks = 0;
  int results = 0;
  Client::SendGoalOptions options;
  options.feedback_callback = [&](Client::GoalHandle::SharedPtr,
                                  const std::shared_ptr<const Fibonacci::Feedback>) {
    ++feedbacks;
  };
  options.result_callback = [&](const Client::WrappedResult&) { ++results; };
  Fibonacci::Goal goal;
  goal.order = 3;
  auto sent = client->async_send_goal(goal, options);
  rclcpp::spin_until_future_complete(node, sent);
  const auto handle = sent.get();
  CHECK(handle != nullptr);
  auto result = client->async_get_result(handle);
  CHECK(rclcpp::spin_until_future_complete(node, result, 5s) == rclcpp::FutureReturnCode::SUCCESS);
  CHECK(result.get().code == rclcpp_action::ResultCode::SUCCEEDED);
  CHECK(result.get().result->sequence.size() == 3);
  CHECK(feedbacks == 3);
  CHECK(results == 1);

  goal.order = 101;
  auto rejected = client->async_send_goal(goal);
  rclcpp::spin_until_future_complete(node, rejected);
  CHECK(rejected.get() == nullptr);

  // Who answers to goals takes the handle, or as ROS 2 Foxy had it, a future of it.
  int answers = 0;
  struct Asker {
    void take(std::shared_future<Client::GoalHandle::SharedPtr> future) {
      answers += future.get() == nullptr ? 1 : 100;
    }
    int& answers;
  } asker{answers};
  Client::SendGoalOptions with;
  const auto answered = [&] {
    return rclcpp::spin_until_future_complete(node, client->async_send_goal(goal, with)) ==
           rclcpp::FutureReturnCode::SUCCESS;
  };
  with.goal_response_callback = [&](const Client::GoalHandle::SharedPtr& none) {
    answers += none == nullptr ? 1 : 100;
  };
  CHECK(answered());
  with.goal_response_callback = [&](auto none) { answers += none == nullptr ? 1 : 100; };
  CHECK(answered());
  with.goal_response_callback = std::bind(&Asker::take, &asker, std::placeholders::_1);
  CHECK(answered());
  with.goal_response_callback = nullptr;
  CHECK(answered());
  CHECK(answers == 3);

  goal.order = 100;
  auto endless = client->async_send_goal(goal);
  rclcpp::spin_until_future_complete(node, endless);
  auto cancelled = client->async_get_result(endless.get());
  auto cancel = client->async_cancel_goal(endless.get());
  rclcpp::spin_until_future_complete(node, cancel);
  CHECK(cancel.get()->goals_canceling.size() == 1);
  rclcpp::spin_until_future_complete(node, cancelled, 5s);
  CHECK(cancelled.get().code == rclcpp_action::ResultCode::CANCELED);
  CHECK_THROWS(rclcpp_action::exceptions::UnknownGoalHandleError,
               client->async_cancel_goal(handle));

  // Nothing is left to cancel, which is an error only to who wants one goal.
  auto none = client->async_cancel_all_goals();
  rclcpp::spin_until_future_complete(node, none);
  CHECK(none.get()->return_code == CancelGoal::Response::ERROR_NONE &&
        none.get()->goals_canceling.empty());

  // A goal that is being cancelled is not asked again.
  work->cancel();
  auto kept = client->async_send_goal(goal);
  rclcpp::spin_until_future_complete(node, kept);
  const int asked_before = asked;
  auto once = client->async_cancel_goal(kept.get());
  rclcpp::spin_until_future_complete(node, once);
  auto twice = client->async_cancel_goal(kept.get());
  rclcpp::spin_until_future_complete(node, twice);
  CHECK(once.get()->return_code == CancelGoal::Response::ERROR_NONE && asked == asked_before + 1);
  CHECK(twice.get()->return_code == CancelGoal::Response::ERROR_GOAL_TERMINATED &&
        twice.get()->goals_canceling.empty());
  return checks.finish();
}
