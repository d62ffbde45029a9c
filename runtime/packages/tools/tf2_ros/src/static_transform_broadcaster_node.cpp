// A component.
#include "tf2_ros/static_transform_broadcaster_node.hpp"

#include <random>
#include <stdexcept>
#include <string>

#include "rclcpp_components/register_node_macro.hpp"

namespace tf2_ros {
namespace {

std::string unique_name() {
  static constexpr char kLetters[] =
      "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::random_device random;
  std::string name = "static_transform_publisher_";
  for (int i = 0; i < 16; ++i) {
    name += kLetters[random() % (sizeof kLetters - 1)];
  }
  return name;
}

}  // namespace

StaticTransformBroadcasterNode::StaticTransformBroadcasterNode(const rclcpp::NodeOptions& options)
    : rclcpp::Node(unique_name(), options) {
  rcl_interfaces::msg::ParameterDescriptor fixed;
  fixed.read_only = true;
  geometry_msgs::msg::TransformStamped transform;
  transform.header.stamp = now();
  auto& translation = transform.transform.translation;
  translation.x = declare_parameter("translation.x", 0.0, fixed);
  translation.y = declare_parameter("translation.y", 0.0, fixed);
  translation.z = declare_parameter("translation.z", 0.0, fixed);
  auto& rotation = transform.transform.rotation;
  rotation.x = declare_parameter("rotation.x", 0.0, fixed);
  rotation.y = declare_parameter("rotation.y", 0.0, fixed);
  rotation.z = declare_parameter("rotation.z", 0.0, fixed);
  rotation.w = declare_parameter("rotation.w", 1.0, fixed);
  transform.header.frame_id = declare_parameter("frame_id", std::string("/frame"), fixed);
  transform.child_frame_id = declare_parameter("child_frame_id", std::string("/child"), fixed);
  if (transform.header.frame_id == transform.child_frame_id) {
    RCLCPP_ERROR(get_logger(), "cannot publish static transform from '%s' to '%s', exiting",
                 transform.header.frame_id.c_str(), transform.child_frame_id.c_str());
    throw std::runtime_error("child_frame_id cannot equal frame_id");
  }
  broadcaster_ = std::make_unique<StaticTransformBroadcaster>(this);
  broadcaster_->sendTransform(transform);
}

}  // namespace tf2_ros

RCLCPP_COMPONENTS_REGISTER_NODE(tf2_ros::StaticTransformBroadcasterNode)
