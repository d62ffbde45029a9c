// Hears both robots.
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("station");
  const auto hear = [&](const std_msgs::msg::String& message) {
    RCLCPP_INFO(node->get_logger(), "%s", message.data.c_str());
  };
  auto first = node->create_subscription<std_msgs::msg::String>("first", 10, hear);
  auto second = node->create_subscription<std_msgs::msg::String>("second", 10, hear);
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
