// Sees two simulators of which one mimics the other: says when both turtles have drawn two sides.
#include <cmath>

#include "rclcpp/rclcpp.hpp"
#include "turtlesim/msg/pose.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("spectator");
  turtlesim::msg::Pose first;
  turtlesim::msg::Pose second;
  bool is_said = false;
  const auto look = [&] {
    // Two units to the right, then up.
    const auto has_two_sides = [](const turtlesim::msg::Pose& pose) {
      return pose.x > 7.3F && pose.x < 7.7F && pose.y > 7.3F && std::abs(pose.theta - M_PI_2) < 0.1;
    };
    if (is_said || !has_two_sides(first) || !has_two_sides(second)) return;
    is_said = true;
    RCLCPP_INFO(node->get_logger(), "two sides, the turtles are %f apart",
                std::hypot(first.x - second.x, first.y - second.y));
  };
  const auto subscribe = [&](const char* topic, turtlesim::msg::Pose& to) {
    return node->create_subscription<turtlesim::msg::Pose>(
        topic, 1, [&look, &to](const turtlesim::msg::Pose& pose) {
          to = pose;
          look();
        });
  };
  const auto one = subscribe("/turtlesim1/turtle1/pose", first);
  const auto other = subscribe("/turtlesim2/turtle1/pose", second);
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
