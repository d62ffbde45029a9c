// Hears all `topics` and the cloud, and every second says as a JSON line how many numbers and clouds came.
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
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
  unsigned long clouds = 0;
  heard.push_back(node->create_subscription<sensor_msgs::msg::PointCloud2>(
    "/cloud", rclcpp::SensorDataQoS(), [&](const sensor_msgs::msg::PointCloud2 &) {++clouds;}));
  auto timer = node->create_wall_timer(std::chrono::seconds(1), [&] {
    std::printf("{\"came\": %lu, \"clouds\": %lu}\n", came, clouds);
    std::fflush(stdout);
    came = clouds = 0;
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
