// An action client: has a counter count to 200, cancels an endless count after its first feedback, and says when the
// counter is gone. Logs what it learns.
#include <algorithm>
#include <functional>

#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using Fibonacci = example_interfaces::action::Fibonacci;
using Client = rclcpp_action::Client<Fibonacci>;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("asker");
  const auto logger = node->get_logger();
  auto client = rclcpp_action::create_client<Fibonacci>(node, "count");
  RCLCPP_INFO(logger, "waiting");
  if (!client->wait_for_action_server()) {return 1;}

  std::vector<std::int32_t> heard;
  Client::SendGoalOptions options;
  options.feedback_callback =
    [&](Client::GoalHandle::SharedPtr, const std::shared_ptr<const Fibonacci::Feedback> feedback) {
      heard.push_back(feedback->sequence.front());
    };
  Fibonacci::Goal goal;
  goal.order = 200;
  auto sent = client->async_send_goal(goal, options);
  rclcpp::spin_until_future_complete(node, sent);
  auto result = client->async_get_result(sent.get());
  rclcpp::spin_until_future_complete(node, result);
  const auto all = result.get();
  // What comes before the goal is known to be accepted, or after its result, is for nobody.
  const bool in_order = !heard.empty() && std::is_sorted(heard.begin(), heard.end(), std::less_equal<>());
  RCLCPP_INFO(
    logger, "result %s with %zu numbers, feedback %s", all.code == rclcpp_action::ResultCode::SUCCEEDED ? "succeeded" : "not",
    all.result->sequence.size(), in_order ? "in order" : "missing or out of order");

  heard.clear();
  goal.order = 1'000'000'000;
  sent = client->async_send_goal(goal, options);
  rclcpp::spin_until_future_complete(node, sent);
  result = client->async_get_result(sent.get());
  while (rclcpp::ok() && heard.empty()) {rclcpp::spin_some(node);}
  auto cancelling = client->async_cancel_goal(sent.get());
  rclcpp::spin_until_future_complete(node, cancelling);
  rclcpp::spin_until_future_complete(node, result);
  RCLCPP_INFO(logger, "cancelled: %s", result.get().code == rclcpp_action::ResultCode::CANCELED ? "yes" : "no");

  rclcpp::Rate rate(100);
  while (rclcpp::ok() && client->action_server_is_ready()) {rate.sleep();}
  RCLCPP_INFO(logger, "the counter is gone");
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
