// The listener's own node, and what it does with a message.
#include "tf2_ros/transform_listener.hpp"

#include <cstdint>
#include <cstdio>
#include <string>

namespace tf2_ros {

TransformListener::TransformListener(tf2::BufferCore& buffer, bool spin_thread) : buffer_(buffer) {
  // The name is an argument, so that a remapping of the program's node does not reach this one.
  char name[42];
  std::snprintf(name, sizeof name, "transform_listener_impl_%zx", reinterpret_cast<size_t>(this));
  rclcpp::NodeOptions options;
  options.arguments({"--ros-args", "-r", std::string("__node:=") + name});
  options.start_parameter_event_publisher(false);
  options.start_parameter_services(false);
  own_node_ = rclcpp::Node::make_shared("_", options);
  node_logging_interface_ = own_node_->get_node_logging_interface();
  listen(own_node_->get_node_base_interface(), own_node_->get_node_parameters_interface(),
         own_node_->get_node_topics_interface(), spin_thread, DynamicListenerQoS(),
         StaticListenerQoS(), detail::get_default_transform_listener_sub_options(),
         detail::get_default_transform_listener_static_sub_options());
}

TransformListener::~TransformListener() = default;

void TransformListener::subscription_callback(tf2_msgs::msg::TFMessage::ConstSharedPtr msg,
                                              bool is_static) {
  for (const auto& transform : msg->transforms) {
    try {
      buffer_.setTransform(transform, "Authority undetectable", is_static);
    } catch (const tf2::TransformException& error) {
      RCLCPP_ERROR(node_logging_interface_->get_logger(),
                   "Failure to set received transform from %s to %s with error: %s\n",
                   transform.child_frame_id.c_str(), transform.header.frame_id.c_str(),
                   error.what());
    }
  }
}

}  // namespace tf2_ros
