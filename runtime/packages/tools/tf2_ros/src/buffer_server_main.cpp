// A buffer for programs that have none: it hears /tf and answers the action `tf2_buffer_server`.
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.hpp"
#include "tf2_ros/buffer_server.hpp"
#include "tf2_ros/transform_listener.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = rclcpp::Node::make_shared("tf_buffer");
  const double buffer_size = node->declare_parameter("buffer_size", 120.0);
  tf2_ros::Buffer buffer(node->get_clock(), tf2::durationFromSec(buffer_size));
  const tf2_ros::TransformListener listener(buffer);
  const tf2_ros::BufferServer server(buffer, node, "tf2_buffer_server");
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
