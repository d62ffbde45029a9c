// Where frames are, by /tf, as transforms of Eigen.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/transform.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

namespace robot_localization {

class Transforms {
 public:
  explicit Transforms(rclcpp::Node& node) : buffer_(node.get_clock()), listener_(buffer_) {}

  /// Waits up to `timeout` seconds for the transform of a time; else takes the newest. A frame seen
  /// from itself is always known.
  std::optional<Eigen::Isometry3d> lookup(const std::string& target, const std::string& source,
                                          const rclcpp::Time& time, double timeout) const;
  std::optional<Eigen::Isometry3d> latest(const std::string& target,
                                          const std::string& source) const;
  void clear() { buffer_.clear(); }

 private:
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

/// A unit quaternion; nothing when all its parts are zero, or one is not finite.
std::optional<Eigen::Quaterniond> rotation_of(const geometry_msgs::msg::Quaternion& message);

geometry_msgs::msg::Quaternion to_message(const Eigen::Quaterniond& rotation);
geometry_msgs::msg::Transform to_message(const Eigen::Isometry3d& transform);

template <typename Message>
Eigen::Vector3d vector_of(const Message& message) {
  return {message.x, message.y, message.z};
}

}  // namespace robot_localization
