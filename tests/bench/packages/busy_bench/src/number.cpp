// Publishes a sine `hz` times a second on `topic`.
#include <chrono>
#include <cmath>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("number");
  const auto hz = node->declare_parameter("hz", 100);
  auto publisher = node->create_publisher<std_msgs::msg::Float64>(node->declare_parameter("topic", "number"), 50);
  std_msgs::msg::Float64 message;
  double time = 0;
  auto timer = node->create_wall_timer(std::chrono::nanoseconds(1'000'000'000 / hz), [&] {
    message.data = std::sin(time);
    time += 1.0 / static_cast<double>(hz);
    publisher->publish(message);
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
