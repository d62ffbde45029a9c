// Values of the simulator as ROS messages.
#pragma once

#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <geometry_msgs/msg/vector3.hpp>

#include <string>

#include "world/world.hpp"

namespace ros2wasm_sim {

inline geometry_msgs::msg::Vector3 vector_message(const Vector3& v) {
  geometry_msgs::msg::Vector3 message;
  message.x = v.x;
  message.y = v.y;
  message.z = v.z;
  return message;
}

inline geometry_msgs::msg::Quaternion quaternion_message(const Quaternion& q) {
  geometry_msgs::msg::Quaternion message;
  message.w = q.w;
  message.x = q.x;
  message.y = q.y;
  message.z = q.z;
  return message;
}

inline geometry_msgs::msg::Pose pose_message(const Pose& pose) {
  geometry_msgs::msg::Pose message;
  message.position.x = pose.position.x;
  message.position.y = pose.position.y;
  message.position.z = pose.position.z;
  message.orientation = quaternion_message(pose.orientation);
  return message;
}

/// A quaternion of zeros counts as no rotation; others are made of length 1.
inline Pose pose_of(const geometry_msgs::msg::Pose& message) {
  const auto& q = message.orientation;
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  Pose pose;
  pose.position = {message.position.x, message.position.y, message.position.z};
  if (size > 0) pose.orientation = {q.w / size, q.x / size, q.y / size, q.z / size};
  return pose;
}

inline geometry_msgs::msg::TransformStamped transform_message(
    const builtin_interfaces::msg::Time& stamp, const std::string& parent, const std::string& child,
    const Pose& pose) {
  geometry_msgs::msg::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation = vector_message(pose.position);
  message.transform.rotation = quaternion_message(pose.orientation);
  return message;
}

/// The link that a joint moves, or an empty text.
inline std::string child_of(const Model& model, const std::string& joint) {
  for (const Joint& one : model.joints)
    if (one.name == joint) return one.child;
  return {};
}

}  // namespace ros2wasm_sim
