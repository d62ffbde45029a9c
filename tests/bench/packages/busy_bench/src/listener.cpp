// Hears all `topics`, and every second says as a JSON line how many numbers came.
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("listener");
  std::vector<rclcpp::SubscriptionBase::SharedPtr> heard;
  unsigned long came = 0;
  for (const auto & topic : node->declare_parameter("topics", std::vector<std::string>())) {
    heard.push_back(node->create_subscription<std_msgs::msg::Float64>(
      topic, 50, [&](const std_msgs::msg::Float64 &) {++came;}));
  }
  auto timer = node->create_wall_timer(std::chrono::seconds(1), [&] {
    std::printf("{\"came\": %lu}\n", came);
    std::fflush(stdout);
    came = 0;
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
