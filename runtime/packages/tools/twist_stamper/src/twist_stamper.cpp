// Gives velocities a header with the time at which they came.
#include <cstdio>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <string>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("twist_stamper");
  const std::string frame_id = node->declare_parameter("frame_id", "");
  const auto output = node->create_publisher<geometry_msgs::msg::TwistStamped>("cmd_vel_out", 10);
  const auto input = node->create_subscription<geometry_msgs::msg::Twist>(
      "cmd_vel_in", 10, [&](const geometry_msgs::msg::Twist& twist) {
        geometry_msgs::msg::TwistStamped message;
        message.header.stamp = node->now();
        message.header.frame_id = frame_id;
        message.twist = twist;
        output->publish(message);
      });
  std::puts("Started twist_stamper!");
  std::fflush(stdout);
  rclcpp::spin(node);
  std::puts("Exiting...");
  rclcpp::shutdown();
  return 0;
}
