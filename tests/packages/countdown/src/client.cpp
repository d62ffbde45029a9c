// Holds the countdown, starts it, and says what it hears.
#include <memory>

#include "countdown_interfaces/action/countdown.hpp"
#include "countdown_interfaces/srv/hold.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using countdown_interfaces::action::Countdown;
using countdown_interfaces::srv::Hold;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("countdown_client");
  auto hold = node->create_client<Hold>("hold");
  hold->wait_for_service();
  hold->configure_introspection(node->get_clock(), rclcpp::ServicesQoS(),
                                RCL_SERVICE_INTROSPECTION_CONTENTS);
  auto watcher = node->create_subscription<Hold::Event>(
      "hold/_service_event", rclcpp::ServicesQoS(), [&](const Hold::Event& event) {
        for (const auto& asked : event.request) {
          RCLCPP_INFO(node->get_logger(), "event: asked to hold for %d", asked.steps);
        }
      });
  auto request = std::make_shared<Hold::Request>();
  request->steps = 3;
  auto answer = hold->async_send_request(request);
  rclcpp::spin_until_future_complete(node, answer);
  RCLCPP_INFO(node->get_logger(), "held: %s", answer.get()->held ? "yes" : "no");

  auto actions = rclcpp_action::create_client<Countdown>(node, "countdown");
  actions->wait_for_action_server();
  Countdown::Goal goal;
  goal.start = 3;
  rclcpp_action::Client<Countdown>::SendGoalOptions options;
  options.feedback_callback = [&](rclcpp_action::ClientGoalHandle<Countdown>::SharedPtr,
                                  const std::shared_ptr<const Countdown::Feedback> feedback) {
    RCLCPP_INFO(node->get_logger(), "left: %d", feedback->left);
  };
  auto sent = actions->async_send_goal(goal, options);
  rclcpp::spin_until_future_complete(node, sent);
  auto result = actions->async_get_result(sent.get());
  rclcpp::spin_until_future_complete(node, result);
  RCLCPP_INFO(node->get_logger(), "done in %d steps", result.get().result->steps);
  rclcpp::shutdown();
  return 0;
}
