// Types of Eigen for tf2: their conversions to messages, and how each is seen from another frame.
#pragma once

#include <Eigen/Geometry>

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "geometry_msgs/msg/transform.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/vector3.hpp"
#include "tf2/convert.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2 {

namespace impl {

template <typename MessageT>
Eigen::Vector3d to_vector(const MessageT& msg) {
  return {msg.x, msg.y, msg.z};
}
template <typename MessageT>
void from_vector(const Eigen::Vector3d& in, MessageT& out) {
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
}
inline Eigen::Quaterniond to_rotation(const geometry_msgs::msg::Quaternion& msg) {
  return Eigen::Quaterniond(msg.w, msg.x, msg.y, msg.z).normalized();
}
inline geometry_msgs::msg::Quaternion from_rotation(const Eigen::Quaterniond& in) {
  geometry_msgs::msg::Quaternion out;
  from_vector(in.vec(), out);
  out.w = in.w();
  return out;
}
template <typename TransformT>
geometry_msgs::msg::Pose to_pose(const TransformT& in) {
  geometry_msgs::msg::Pose out;
  from_vector(in.translation(), out.position);
  out.orientation = from_rotation(Eigen::Quaterniond(in.linear()));
  return out;
}
template <typename TransformT>
TransformT from_pose(const geometry_msgs::msg::Pose& msg) {
  return TransformT(Eigen::Translation3d(to_vector(msg.position)) * to_rotation(msg.orientation));
}

}  // namespace impl

// --- transforms -------------------------------------------------------------------------------

inline Eigen::Isometry3d transformToEigen(const geometry_msgs::msg::Transform& t) {
  return Eigen::Isometry3d(Eigen::Translation3d(impl::to_vector(t.translation)) *
                           impl::to_rotation(t.rotation));
}
inline Eigen::Isometry3d transformToEigen(const geometry_msgs::msg::TransformStamped& t) {
  return transformToEigen(t.transform);
}
/// The header is left empty.
inline geometry_msgs::msg::TransformStamped eigenToTransform(const Eigen::Affine3d& T) {
  geometry_msgs::msg::TransformStamped t;
  impl::from_vector(T.translation(), t.transform.translation);
  t.transform.rotation = impl::from_rotation(Eigen::Quaterniond(T.linear()).normalized());
  return t;
}
inline geometry_msgs::msg::TransformStamped eigenToTransform(const Eigen::Isometry3d& T) {
  geometry_msgs::msg::TransformStamped t;
  impl::from_vector(T.translation(), t.transform.translation);
  t.transform.rotation = impl::from_rotation(Eigen::Quaterniond(T.linear()));
  return t;
}

// --- conversions ------------------------------------------------------------------------------

inline geometry_msgs::msg::Point toMsg(const Eigen::Vector3d& in) {
  geometry_msgs::msg::Point out;
  impl::from_vector(in, out);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Point& msg, Eigen::Vector3d& out) {
  out = impl::to_vector(msg);
}
inline geometry_msgs::msg::Vector3& toMsg(const Eigen::Vector3d& in,
                                          geometry_msgs::msg::Vector3& out) {
  impl::from_vector(in, out);
  return out;
}
inline geometry_msgs::msg::Vector3 toMsg2(const Eigen::Vector3d& in) {
  geometry_msgs::msg::Vector3 out;
  return toMsg(in, out);
}
inline void fromMsg(const geometry_msgs::msg::Vector3& msg, Eigen::Vector3d& out) {
  out = impl::to_vector(msg);
}
inline geometry_msgs::msg::Quaternion toMsg(const Eigen::Quaterniond& in) {
  return impl::from_rotation(in);
}
inline void fromMsg(const geometry_msgs::msg::Quaternion& msg, Eigen::Quaterniond& out) {
  out = impl::to_rotation(msg);
}
inline geometry_msgs::msg::Pose toMsg(const Eigen::Affine3d& in) {
  return impl::to_pose(in);
}
inline geometry_msgs::msg::Pose toMsg(const Eigen::Isometry3d& in) {
  return impl::to_pose(in);
}
inline void fromMsg(const geometry_msgs::msg::Pose& msg, Eigen::Affine3d& out) {
  out = impl::from_pose<Eigen::Affine3d>(msg);
}
inline void fromMsg(const geometry_msgs::msg::Pose& msg, Eigen::Isometry3d& out) {
  out = impl::from_pose<Eigen::Isometry3d>(msg);
}
/// Linear velocity first.
inline geometry_msgs::msg::Twist toMsg(const Eigen::Matrix<double, 6, 1>& in) {
  geometry_msgs::msg::Twist out;
  impl::from_vector(in.head<3>(), out.linear);
  impl::from_vector(in.tail<3>(), out.angular);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Twist& msg, Eigen::Matrix<double, 6, 1>& out) {
  out << impl::to_vector(msg.linear), impl::to_vector(msg.angular);
}

// --- conversions of what has a time and a frame -------------------------------------------------

inline geometry_msgs::msg::PointStamped toMsg(const Stamped<Eigen::Vector3d>& in) {
  geometry_msgs::msg::PointStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  out.point = toMsg(static_cast<const Eigen::Vector3d&>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PointStamped& msg, Stamped<Eigen::Vector3d>& out) {
  impl::take_header(msg, out);
  fromMsg(msg.point, static_cast<Eigen::Vector3d&>(out));
}
inline geometry_msgs::msg::QuaternionStamped toMsg(const Stamped<Eigen::Quaterniond>& in) {
  geometry_msgs::msg::QuaternionStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  out.quaternion = toMsg(static_cast<const Eigen::Quaterniond&>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::QuaternionStamped& msg,
                    Stamped<Eigen::Quaterniond>& out) {
  impl::take_header(msg, out);
  fromMsg(msg.quaternion, static_cast<Eigen::Quaterniond&>(out));
}
inline geometry_msgs::msg::PoseStamped toMsg(const Stamped<Eigen::Affine3d>& in) {
  geometry_msgs::msg::PoseStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  out.pose = toMsg(static_cast<const Eigen::Affine3d&>(in));
  return out;
}
inline geometry_msgs::msg::PoseStamped toMsg(const Stamped<Eigen::Isometry3d>& in) {
  geometry_msgs::msg::PoseStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  out.pose = toMsg(static_cast<const Eigen::Isometry3d&>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PoseStamped& msg, Stamped<Eigen::Affine3d>& out) {
  impl::take_header(msg, out);
  fromMsg(msg.pose, static_cast<Eigen::Affine3d&>(out));
}
inline void fromMsg(const geometry_msgs::msg::PoseStamped& msg, Stamped<Eigen::Isometry3d>& out) {
  impl::take_header(msg, out);
  fromMsg(msg.pose, static_cast<Eigen::Isometry3d&>(out));
}

// --- seen from another frame --------------------------------------------------------------------

template <>
inline void doTransform(const Eigen::Vector3d& t_in, Eigen::Vector3d& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  t_out = transformToEigen(transform) * t_in;
}
template <>
inline void doTransform(const Eigen::Quaterniond& t_in, Eigen::Quaterniond& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  t_out = impl::to_rotation(transform.transform.rotation) * t_in;
}
template <>
inline void doTransform(const Eigen::Affine3d& t_in, Eigen::Affine3d& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  t_out = Eigen::Affine3d(transformToEigen(transform) * t_in);
}
template <>
inline void doTransform(const Eigen::Isometry3d& t_in, Eigen::Isometry3d& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  t_out = transformToEigen(transform) * t_in;
}
/// Six numbers: a twist, angular velocity first, or a wrench, force first.
template <>
inline void doTransform(const Eigen::VectorXd& t_in, Eigen::VectorXd& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  const Eigen::Isometry3d frame = transformToEigen(transform);
  const Eigen::Vector3d first = frame.linear() * t_in.segment<3>(0);
  const Eigen::Vector3d second = frame.linear() * t_in.segment<3>(3);
  const Eigen::Vector3d arm = frame.translation();
  t_out.resize(6);
  t_out << first, second + arm.cross(first);
}

namespace impl {

template <typename T>
void transform_stamped(const Stamped<T>& in, Stamped<T>& out,
                       const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(static_cast<const T&>(in), static_cast<T&>(out), transform);
  take_header(transform, out);
}

}  // namespace impl

template <>
inline void doTransform(const Stamped<Eigen::Vector3d>& t_in, Stamped<Eigen::Vector3d>& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::transform_stamped(t_in, t_out, transform);
}
template <>
inline void doTransform(const Stamped<Eigen::Quaterniond>& t_in, Stamped<Eigen::Quaterniond>& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::transform_stamped(t_in, t_out, transform);
}
template <>
inline void doTransform(const Stamped<Eigen::Affine3d>& t_in, Stamped<Eigen::Affine3d>& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::transform_stamped(t_in, t_out, transform);
}
template <>
inline void doTransform(const Stamped<Eigen::Isometry3d>& t_in, Stamped<Eigen::Isometry3d>& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::transform_stamped(t_in, t_out, transform);
}

}  // namespace tf2

// tf2::convert finds these by the namespace of their arguments.
namespace Eigen {

using tf2::fromMsg;
using tf2::toMsg;

}  // namespace Eigen
