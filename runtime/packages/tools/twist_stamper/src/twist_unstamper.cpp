// Takes the header from velocities.
#include <cstdio>
#include <memory>
#include <rclcpp/rclcpp.hpp>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("twist_unstamper");
  const auto output = node->create_publisher<geometry_msgs::msg::Twist>("cmd_vel_out", 10);
  const auto input = node->create_subscription<geometry_msgs::msg::TwistStamped>(
      "cmd_vel_in", 10,
      [&](const geometry_msgs::msg::TwistStamped& message) { output->publish(message.twist); });
  std::puts("Started twist_unstamper!");
  std::fflush(stdout);
  rclcpp::spin(node);
  std::puts("Exiting...");
  rclcpp::shutdown();
  return 0;
}
