// Publishes a waving cloud of `points` points `hz` times a second on /cloud, in the frame `map`.
#include <chrono>
#include <cmath>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("lidar");
  const auto hz = node->declare_parameter("hz", 10);
  const auto side = static_cast<unsigned>(std::sqrt(node->declare_parameter("points", 10'000)));
  auto publisher = node->create_publisher<sensor_msgs::msg::PointCloud2>("/cloud", rclcpp::SensorDataQoS());
  sensor_msgs::msg::PointCloud2 message;
  message.header.frame_id = "map";
  sensor_msgs::PointCloud2Modifier(message).setPointCloud2FieldsByString(1, "xyz");
  sensor_msgs::PointCloud2Modifier(message).resize(side * side);
  float time = 0;
  auto timer = node->create_wall_timer(std::chrono::nanoseconds(1'000'000'000 / hz), [&] {
    time += 1.0F / static_cast<float>(hz);
    sensor_msgs::PointCloud2Iterator<float> point(message, "x");
    for (unsigned i = 0; i < side * side; ++i, ++point) {
      const float x = 10.0F * static_cast<float>(i % side) / static_cast<float>(side) - 5.0F;
      const float y = 10.0F * static_cast<float>(i / side) / static_cast<float>(side) - 5.0F;
      point[0] = x;
      point[1] = y;
      point[2] = std::sin(x + time) * std::cos(y);
    }
    message.header.stamp = node->now();
    publisher->publish(message);
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
