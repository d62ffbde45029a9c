// An action server: counts up to the goal's order, a number every millisecond, each as feedback. Takes every goal.
#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using Fibonacci = example_interfaces::action::Fibonacci;
using Handle = rclcpp_action::ServerGoalHandle<Fibonacci>;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("counter");
  std::shared_ptr<Handle> active;
  auto counted = std::make_shared<Fibonacci::Result>();
  auto server = rclcpp_action::create_server<Fibonacci>(
    node, "count",
    [](const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal>) {
      return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
    },
    [](const std::shared_ptr<Handle>) {return rclcpp_action::CancelResponse::ACCEPT;},
    [&](const std::shared_ptr<Handle> handle) {
      active = handle;
      counted = std::make_shared<Fibonacci::Result>();
    });
  auto work = node->create_wall_timer(std::chrono::milliseconds(1), [&] {
    if (!active) {return;}
    if (active->is_canceling()) {
      RCLCPP_INFO(node->get_logger(), "cancelled at %zu", counted->sequence.size());
      active->canceled(counted);
      active.reset();
      return;
    }
    counted->sequence.push_back(static_cast<std::int32_t>(counted->sequence.size()));
    auto feedback = std::make_shared<Fibonacci::Feedback>();
    feedback->sequence = {counted->sequence.back()};
    active->publish_feedback(feedback);
    if (counted->sequence.size() == static_cast<std::size_t>(active->get_goal()->order)) {
      active->succeed(counted);
      active.reset();
    }
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
