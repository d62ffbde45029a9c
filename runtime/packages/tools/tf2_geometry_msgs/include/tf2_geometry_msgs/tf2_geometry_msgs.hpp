// Geometry messages for tf2: their conversions, and how each is seen from another frame.
#pragma once

#include <array>
#include <string>

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/point32.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/polygon.hpp"
#include "geometry_msgs/msg/polygon_stamped.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "geometry_msgs/msg/transform.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/vector3.hpp"
#include "geometry_msgs/msg/vector3_stamped.hpp"
#include "geometry_msgs/msg/velocity_stamped.hpp"
#include "geometry_msgs/msg/wrench.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Transform.hpp"
#include "tf2/LinearMath/Vector3.hpp"
#include "tf2/convert.hpp"
#include "tf2_ros/buffer_interface.hpp"
#if __has_include(<kdl/frames.hpp>)
#include <kdl/frames.hpp>
#endif

namespace tf2 {

#if __has_include(<kdl/frames.hpp>)
/// For packages that ask for KDL (orocos_kdl_vendor): the others carry nothing of it.
inline KDL::Frame gmTransformToKDL(const geometry_msgs::msg::TransformStamped& t) {
  const auto& translation = t.transform.translation;
  const auto& rotation = t.transform.rotation;
  return {KDL::Rotation::Quaternion(rotation.x, rotation.y, rotation.z, rotation.w),
          KDL::Vector(translation.x, translation.y, translation.z)};
}
#endif

// --- vectors and points ---------------------------------------------------------------------

inline geometry_msgs::msg::Vector3 toMsg(const Vector3& in) {
  geometry_msgs::msg::Vector3 out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Vector3& in, Vector3& out) {
  out = Vector3(in.x, in.y, in.z);
}
inline geometry_msgs::msg::Point& toMsg(const Vector3& in, geometry_msgs::msg::Point& out) {
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Point& in, Vector3& out) {
  out = Vector3(in.x, in.y, in.z);
}
inline geometry_msgs::msg::Point32& toMsg(const Vector3& in, geometry_msgs::msg::Point32& out) {
  out.x = static_cast<float>(in.x());
  out.y = static_cast<float>(in.y());
  out.z = static_cast<float>(in.z());
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Point32& in, Vector3& out) {
  out = Vector3(in.x, in.y, in.z);
}

// --- rotations, transforms, poses -----------------------------------------------------------

inline geometry_msgs::msg::Quaternion toMsg(const Quaternion& in) {
  geometry_msgs::msg::Quaternion out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  out.w = in.w();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Quaternion& in, Quaternion& out) {
  out = Quaternion(in.x, in.y, in.z, in.w);
}
inline geometry_msgs::msg::Transform toMsg(const Transform& in) {
  geometry_msgs::msg::Transform out;
  out.translation = toMsg(in.getOrigin());
  out.rotation = toMsg(in.getRotation());
  return out;
}
inline void toMsg(const Transform& in, geometry_msgs::msg::Transform& out) {
  out = toMsg(in);
}
inline void fromMsg(const geometry_msgs::msg::Transform& in, Transform& out) {
  Quaternion rotation;
  Vector3 translation;
  fromMsg(in.rotation, rotation);
  fromMsg(in.translation, translation);
  out = Transform(rotation, translation);
}
inline void toMsg(const Transform& in, geometry_msgs::msg::Pose& out) {
  toMsg(in.getOrigin(), out.position);
  out.orientation = toMsg(in.getRotation());
}
inline void fromMsg(const geometry_msgs::msg::Pose& in, Transform& out) {
  Quaternion rotation;
  Vector3 translation;
  fromMsg(in.orientation, rotation);
  fromMsg(in.position, translation);
  out = Transform(rotation, translation);
}

// --- messages with a header -----------------------------------------------------------------

namespace impl {

template <typename MessageT>
void set_header(const TimePoint& stamp, const std::string& frame_id, MessageT& out) {
  out.header.stamp = tf2_ros::toMsg(stamp);
  out.header.frame_id = frame_id;
}
template <typename MessageT, typename StampedT>
void take_header(const MessageT& in, StampedT& out) {
  out.stamp_ = tf2_ros::fromMsg(in.header.stamp);
  out.frame_id_ = in.header.frame_id;
}

}  // namespace impl

/// Time and frame of a stamped message, and its conversions to itself, which `transform` needs.
#define TF2_GEOMETRY_MSGS_STAMPED(NAME)                              \
  template <>                                                        \
  inline TimePoint getTimestamp(const geometry_msgs::msg::NAME& t) { \
    return tf2_ros::fromMsg(t.header.stamp);                         \
  }                                                                  \
  template <>                                                        \
  inline std::string getFrameId(const geometry_msgs::msg::NAME& t) { \
    return t.header.frame_id;                                        \
  }                                                                  \
  TF2_GEOMETRY_MSGS_PLAIN(NAME)
#define TF2_GEOMETRY_MSGS_PLAIN(NAME)                                                       \
  inline geometry_msgs::msg::NAME toMsg(const geometry_msgs::msg::NAME& in) {               \
    return in;                                                                              \
  }                                                                                         \
  inline void fromMsg(const geometry_msgs::msg::NAME& msg, geometry_msgs::msg::NAME& out) { \
    out = msg;                                                                              \
  }

TF2_GEOMETRY_MSGS_STAMPED(Vector3Stamped)
TF2_GEOMETRY_MSGS_STAMPED(PointStamped)
TF2_GEOMETRY_MSGS_STAMPED(PoseStamped)
TF2_GEOMETRY_MSGS_STAMPED(PolygonStamped)
TF2_GEOMETRY_MSGS_STAMPED(PoseWithCovarianceStamped)
TF2_GEOMETRY_MSGS_STAMPED(QuaternionStamped)
TF2_GEOMETRY_MSGS_STAMPED(TransformStamped)
TF2_GEOMETRY_MSGS_STAMPED(VelocityStamped)
TF2_GEOMETRY_MSGS_STAMPED(WrenchStamped)
TF2_GEOMETRY_MSGS_PLAIN(Polygon)
TF2_GEOMETRY_MSGS_PLAIN(Pose)
TF2_GEOMETRY_MSGS_PLAIN(PoseWithCovariance)

#undef TF2_GEOMETRY_MSGS_PLAIN
#undef TF2_GEOMETRY_MSGS_STAMPED

template <>
inline std::array<std::array<double, 6>, 6> getCovarianceMatrix(
    const geometry_msgs::msg::PoseWithCovariance& t) {
  return covarianceRowMajorToNested(t.covariance);
}
template <>
inline std::array<std::array<double, 6>, 6> getCovarianceMatrix(
    const geometry_msgs::msg::PoseWithCovarianceStamped& t) {
  return getCovarianceMatrix(t.pose);
}
inline geometry_msgs::msg::QuaternionStamped toMsg(const Stamped<Quaternion>& in) {
  geometry_msgs::msg::QuaternionStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  out.quaternion = toMsg(static_cast<const Quaternion&>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::QuaternionStamped& in, Stamped<Quaternion>& out) {
  impl::take_header(in, out);
  fromMsg(in.quaternion, static_cast<Quaternion&>(out));
}
inline geometry_msgs::msg::TransformStamped toMsg(const Stamped<Transform>& in) {
  geometry_msgs::msg::TransformStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  out.transform = toMsg(static_cast<const Transform&>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::TransformStamped& in, Stamped<Transform>& out) {
  impl::take_header(in, out);
  fromMsg(in.transform, static_cast<Transform&>(out));
}
inline geometry_msgs::msg::PoseWithCovarianceStamped toMsg(
    const WithCovarianceStamped<Transform>& in) {
  geometry_msgs::msg::PoseWithCovarianceStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  out.pose.covariance = covarianceNestedToRowMajor(in.cov_mat_);
  toMsg(static_cast<const Transform&>(in), out.pose.pose);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PoseWithCovarianceStamped& in,
                    WithCovarianceStamped<Transform>& out) {
  impl::take_header(in, out);
  out.cov_mat_ = covarianceRowMajorToNested(in.pose.covariance);
  fromMsg(in.pose.pose, static_cast<Transform&>(out));
}

// --- as seen from another frame -------------------------------------------------------------

namespace impl {

inline Transform transform_of(const geometry_msgs::msg::TransformStamped& transform) {
  Transform out;
  fromMsg(transform.transform, out);
  return out;
}
/// Moves a point of any message type.
template <typename PointT>
void move_point(const PointT& in, PointT& out, const Transform& transform) {
  Vector3 point;
  fromMsg(in, point);
  toMsg(transform * point, out);
}
/// Turns a vector, which has no place.
inline geometry_msgs::msg::Vector3 turn(const geometry_msgs::msg::Vector3& in,
                                        const Transform& transform) {
  return toMsg(transform.getBasis() * Vector3(in.x, in.y, in.z));
}

}  // namespace impl

template <>
inline void doTransform(const geometry_msgs::msg::Vector3& t_in, geometry_msgs::msg::Vector3& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  t_out = impl::turn(t_in, impl::transform_of(transform));
}
template <>
inline void doTransform(const geometry_msgs::msg::Vector3Stamped& t_in,
                        geometry_msgs::msg::Vector3Stamped& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(t_in.vector, t_out.vector, transform);
  t_out.header = transform.header;
}
template <>
inline void doTransform(const geometry_msgs::msg::Point& t_in, geometry_msgs::msg::Point& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::move_point(t_in, t_out, impl::transform_of(transform));
}
template <>
inline void doTransform(const geometry_msgs::msg::Point32& t_in, geometry_msgs::msg::Point32& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::move_point(t_in, t_out, impl::transform_of(transform));
}
template <>
inline void doTransform(const geometry_msgs::msg::PointStamped& t_in,
                        geometry_msgs::msg::PointStamped& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(t_in.point, t_out.point, transform);
  t_out.header = transform.header;
}
template <>
inline void doTransform(const geometry_msgs::msg::Polygon& poly_in,
                        geometry_msgs::msg::Polygon& poly_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  const Transform moved = impl::transform_of(transform);
  auto points = poly_in.points;
  for (auto& point : points) {
    impl::move_point(point, point, moved);
  }
  poly_out.points = points;
}
template <>
inline void doTransform(const geometry_msgs::msg::PolygonStamped& poly_in,
                        geometry_msgs::msg::PolygonStamped& poly_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(poly_in.polygon, poly_out.polygon, transform);
  poly_out.header = transform.header;
}
template <>
inline void doTransform(const geometry_msgs::msg::Quaternion& t_in,
                        geometry_msgs::msg::Quaternion& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  Quaternion rotation;
  Quaternion q;
  fromMsg(transform.transform.rotation, rotation);
  fromMsg(t_in, q);
  t_out = toMsg(rotation * q);
}
template <>
inline void doTransform(const geometry_msgs::msg::QuaternionStamped& t_in,
                        geometry_msgs::msg::QuaternionStamped& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(t_in.quaternion, t_out.quaternion, transform);
  t_out.header = transform.header;
}
template <>
inline void doTransform(const geometry_msgs::msg::Pose& t_in, geometry_msgs::msg::Pose& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  Transform pose;
  fromMsg(t_in, pose);
  toMsg(impl::transform_of(transform) * pose, t_out);
}
template <>
inline void doTransform(const geometry_msgs::msg::PoseStamped& t_in,
                        geometry_msgs::msg::PoseStamped& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(t_in.pose, t_out.pose, transform);
  t_out.header = transform.header;
}
template <>
inline void doTransform(const geometry_msgs::msg::Transform& t_in,
                        geometry_msgs::msg::Transform& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  Transform inner;
  fromMsg(t_in, inner);
  t_out = toMsg(impl::transform_of(transform) * inner);
}
/// The child stays the one of `t_in`.
template <>
inline void doTransform(const geometry_msgs::msg::TransformStamped& t_in,
                        geometry_msgs::msg::TransformStamped& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  t_out.child_frame_id = t_in.child_frame_id;
  doTransform(t_in.transform, t_out.transform, transform);
  t_out.header = transform.header;
}

/// Each of the four blocks (position and rotation against both) is turned: R C R^T.
inline geometry_msgs::msg::PoseWithCovariance::_covariance_type transformCovariance(
    const geometry_msgs::msg::PoseWithCovariance::_covariance_type& cov_in,
    const Transform& transform) {
  const Matrix3x3& rotation = transform.getBasis();
  geometry_msgs::msg::PoseWithCovariance::_covariance_type cov_out;
  for (const int corner : {0, 3, 18, 21}) {
    Matrix3x3 block;
    for (int i = 0; i < 9; ++i) {
      block[i / 3][i % 3] = cov_in[corner + i / 3 * 6 + i % 3];
    }
    const Matrix3x3 turned = (rotation * block).timesTranspose(rotation);
    for (int i = 0; i < 9; ++i) {
      cov_out[corner + i / 3 * 6 + i % 3] = turned[i / 3][i % 3];
    }
  }
  return cov_out;
}
template <>
inline void doTransform(const geometry_msgs::msg::PoseWithCovariance& t_in,
                        geometry_msgs::msg::PoseWithCovariance& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(t_in.pose, t_out.pose, transform);
  t_out.covariance = transformCovariance(t_in.covariance, impl::transform_of(transform));
}
template <>
inline void doTransform(const geometry_msgs::msg::PoseWithCovarianceStamped& t_in,
                        geometry_msgs::msg::PoseWithCovarianceStamped& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(t_in.pose, t_out.pose, transform);
  t_out.header = transform.header;
}

/// The result is the sum of the given velocity and its transform into the target frame.
template <>
inline void doTransform(const geometry_msgs::msg::VelocityStamped& t_in,
                        geometry_msgs::msg::VelocityStamped& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  const Transform moved = impl::transform_of(transform);
  Vector3 linear;
  Vector3 angular;
  fromMsg(t_in.velocity.linear, linear);
  fromMsg(t_in.velocity.angular, angular);
  const Vector3 turning = moved.getBasis() * angular;
  const Vector3 moving = moved.getBasis() * linear + moved.getOrigin().cross(turning);
  t_out.header = t_in.header;
  t_out.velocity.linear = toMsg(moving + linear);
  t_out.velocity.angular = toMsg(turning + angular);
}
/// A force away from the origin also turns.
template <>
inline void doTransform(const geometry_msgs::msg::Wrench& t_in, geometry_msgs::msg::Wrench& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  const Transform moved = impl::transform_of(transform);
  Vector3 force;
  Vector3 torque;
  fromMsg(t_in.force, force);
  fromMsg(t_in.torque, torque);
  force = moved.getBasis() * force;
  t_out.force = toMsg(force);
  t_out.torque = toMsg(moved.getBasis() * torque + moved.getOrigin().cross(force));
}
template <>
inline void doTransform(const geometry_msgs::msg::WrenchStamped& t_in,
                        geometry_msgs::msg::WrenchStamped& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  doTransform(t_in.wrench, t_out.wrench, transform);
  t_out.header = transform.header;
}

}  // namespace tf2
