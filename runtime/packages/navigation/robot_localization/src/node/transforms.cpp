// See transforms.hpp.
#include "node/transforms.hpp"

#include "tf2/exceptions.h"

namespace robot_localization {
namespace {

Eigen::Isometry3d eigen_of(const geometry_msgs::msg::Transform& message) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = vector_of(message.translation);
  if (const auto rotation = rotation_of(message.rotation)) {
    result.linear() = rotation->toRotationMatrix();
  }
  return result;
}

}  // namespace

std::optional<Eigen::Isometry3d> Transforms::latest(const std::string& target,
                                                    const std::string& source) const {
  if (target == source) return Eigen::Isometry3d::Identity();
  // An exception costs more than the question.
  if (!buffer_.canTransform(target, source, tf2::TimePointZero)) return std::nullopt;
  try {
    return eigen_of(buffer_.lookupTransform(target, source, tf2::TimePointZero).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::optional<Eigen::Isometry3d> Transforms::lookup(const std::string& target,
                                                    const std::string& source,
                                                    const rclcpp::Time& time,
                                                    double timeout) const {
  if (target == source) return Eigen::Isometry3d::Identity();
  try {
    const auto wait = rclcpp::Duration::from_seconds(timeout);
    if (buffer_.canTransform(target, source, time, wait)) {
      return eigen_of(buffer_.lookupTransform(target, source, time).transform);
    }
  } catch (const tf2::TransformException&) {
    // It has left the buffer meanwhile.
  }
  return latest(target, source);
}

std::optional<Eigen::Quaterniond> rotation_of(const geometry_msgs::msg::Quaternion& message) {
  const Eigen::Quaterniond rotation(message.w, message.x, message.y, message.z);
  const double length = rotation.norm();
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  return rotation.normalized();
}

geometry_msgs::msg::Quaternion to_message(const Eigen::Quaterniond& rotation) {
  geometry_msgs::msg::Quaternion result;
  result.x = rotation.x();
  result.y = rotation.y();
  result.z = rotation.z();
  result.w = rotation.w();
  return result;
}

geometry_msgs::msg::Transform to_message(const Eigen::Isometry3d& transform) {
  geometry_msgs::msg::Transform result;
  result.translation.x = transform.translation().x();
  result.translation.y = transform.translation().y();
  result.translation.z = transform.translation().z();
  result.rotation = to_message(Eigen::Quaterniond(transform.linear()));
  return result;
}

}  // namespace robot_localization
