// Publishes a moving picture of 640 x 480, three bytes a pixel, `hz` times a second on /image.
#include <chrono>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/image.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("camera");
  const auto hz = node->declare_parameter("hz", 15);
  auto publisher = node->create_publisher<sensor_msgs::msg::Image>("/image", rclcpp::SensorDataQoS());
  sensor_msgs::msg::Image message;
  message.header.frame_id = "map";
  message.width = 640;
  message.height = 480;
  message.encoding = "rgb8";
  message.step = message.width * 3;
  message.data.resize(message.step * message.height);
  unsigned moved = 0;
  auto timer = node->create_wall_timer(std::chrono::nanoseconds(1'000'000'000 / hz), [&] {
    ++moved;
    for (unsigned y = 0; y < message.height; ++y) {
      std::uint8_t * row = &message.data[y * message.step];
      for (unsigned x = 0; x < message.step; ++x) {
        row[x] = static_cast<std::uint8_t>(x / 3 + y + moved);
      }
    }
    message.header.stamp = node->now();
    publisher->publish(message);
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
