// Moves one turtle as another one moves.
#include <memory>
#include <rclcpp/rclcpp.hpp>

#include "geometry_msgs/msg/twist.hpp"
#include "turtlesim/msg/pose.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("turtle_mimic");
  const auto commands = node->create_publisher<geometry_msgs::msg::Twist>("output/cmd_vel", 1);
  const auto poses = node->create_subscription<turtlesim::msg::Pose>(
      "input/pose", 1, [&commands](const turtlesim::msg::Pose& pose) {
        geometry_msgs::msg::Twist command;
        command.linear.x = pose.linear_velocity;
        command.angular.z = pose.angular_velocity;
        commands->publish(command);
      });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
