// Says where it is; its battery lasts for some steps, and then the program ends.
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("robot");
  const double speed = node->declare_parameter("speed", 0.0);
  const auto battery = node->declare_parameter("battery", 1000);
  auto position = node->create_publisher<std_msgs::msg::String>("position", 10);
  double x = 0;
  int64_t steps = 0;
  auto timer = node->create_wall_timer(std::chrono::milliseconds(500), [&] {
    x += speed / 2;
    std_msgs::msg::String message;
    message.data = std::string(node->get_namespace()) + " is at " + std::to_string(x);
    position->publish(message);
    if (++steps == battery) {
      RCLCPP_WARN(node->get_logger(), "the battery is empty");
      rclcpp::shutdown();
    }
  });
  RCLCPP_INFO(node->get_logger(), "starting at %.1f m/s", speed);
  rclcpp::spin(node);
  return 0;
}
