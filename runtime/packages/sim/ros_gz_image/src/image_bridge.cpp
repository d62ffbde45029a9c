// image_bridge: carries images of Gazebo to topics of ROS with the same names, as they are.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "ros2wasm_sim/gz_names.hpp"

namespace ros_gz_image {
namespace {

constexpr const char* kType = "sensor_msgs/msg/Image";

/// The QoS that the node's parameter `qos` names; the default for an unknown name.
rclcpp::QoS qos_of(rclcpp::Node& node) {
  const std::string name = node.declare_parameter("qos", "default");
  if (name == "sensor_data") return rclcpp::SensorDataQoS();
  if (name == "system_default") return rclcpp::SystemDefaultsQoS();
  if (name != "default")
    RCLCPP_ERROR(node.get_logger(), "Invalid QoS profile %s specified. Using default profile.",
                 name.c_str());
  return rclcpp::QoS(10);
}

class ImageBridge : public rclcpp::Node {
 public:
  explicit ImageBridge(const std::vector<std::string>& topics) : rclcpp::Node("ros_gz_image") {
    const rclcpp::QoS qos = qos_of(*this);
    for (const std::string& topic : topics) {
      const auto publisher = create_generic_publisher(topic, kType, qos);
      subscriptions_.push_back(create_generic_subscription(
          ros2wasm_sim::hidden_name(topic), kType, rclcpp::QoS(10).best_effort(),
          [publisher](std::shared_ptr<rclcpp::SerializedMessage> image) {
            publisher->publish(*image);
          }));
    }
  }

 private:
  std::vector<rclcpp::GenericSubscription::SharedPtr> subscriptions_;
};

}  // namespace
}  // namespace ros_gz_image

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "Carries images from topics of Gazebo to ROS.\n\n"
                 "  image_bridge <topic> <topic> ..\n\n"
                 "Example:\n"
                 "  image_bridge /camera/image_raw"
              << std::endl;
    return -1;
  }
  auto topics = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (!topics.empty()) topics.erase(topics.begin());
  rclcpp::spin(std::make_shared<ros_gz_image::ImageBridge>(topics));
  rclcpp::shutdown();
  return 0;
}
