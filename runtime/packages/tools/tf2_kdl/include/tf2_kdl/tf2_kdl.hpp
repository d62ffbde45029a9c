// Types of KDL for tf2: their conversions to messages, and how each is seen from another frame.
#pragma once

#include <kdl/frames.hpp>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "tf2/convert.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"

namespace tf2 {

namespace impl {

template <typename MessageT>
KDL::Vector to_kdl(const MessageT& msg) {
  return {msg.x, msg.y, msg.z};
}
inline KDL::Rotation to_kdl(const geometry_msgs::msg::Quaternion& msg) {
  return KDL::Rotation::Quaternion(msg.x, msg.y, msg.z, msg.w);
}
template <typename MessageT>
void from_kdl(const KDL::Vector& in, MessageT& out) {
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
}
inline void from_kdl(const KDL::Rotation& in, geometry_msgs::msg::Quaternion& out) {
  in.GetQuaternion(out.x, out.y, out.z, out.w);
}
/// A value of KDL as it is in the frame that a transform leads to, with the time of that.
template <typename T>
void seen_from(const Stamped<T>& in, Stamped<T>& out,
               const geometry_msgs::msg::TransformStamped& transform) {
  const KDL::Frame frame(to_kdl(transform.transform.rotation),
                         to_kdl(transform.transform.translation));
  out = Stamped<T>(frame * static_cast<const T&>(in), tf2_ros::fromMsg(transform.header.stamp),
                   transform.header.frame_id);
}

}  // namespace impl

// --- transforms -------------------------------------------------------------------------------

inline KDL::Frame transformToKDL(const geometry_msgs::msg::TransformStamped& t) {
  return {impl::to_kdl(t.transform.rotation), impl::to_kdl(t.transform.translation)};
}
/// The header is left empty.
inline geometry_msgs::msg::TransformStamped kdlToTransform(const KDL::Frame& k) {
  geometry_msgs::msg::TransformStamped t;
  impl::from_kdl(k.p, t.transform.translation);
  impl::from_kdl(k.M, t.transform.rotation);
  return t;
}

// --- conversions ------------------------------------------------------------------------------

inline geometry_msgs::msg::PointStamped toMsg(const Stamped<KDL::Vector>& in) {
  geometry_msgs::msg::PointStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  impl::from_kdl(in, out.point);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PointStamped& msg, Stamped<KDL::Vector>& out) {
  impl::take_header(msg, out);
  static_cast<KDL::Vector&>(out) = impl::to_kdl(msg.point);
}
inline geometry_msgs::msg::TwistStamped toMsg(const Stamped<KDL::Twist>& in) {
  geometry_msgs::msg::TwistStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  impl::from_kdl(in.vel, out.twist.linear);
  impl::from_kdl(in.rot, out.twist.angular);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::TwistStamped& msg, Stamped<KDL::Twist>& out) {
  impl::take_header(msg, out);
  out.vel = impl::to_kdl(msg.twist.linear);
  out.rot = impl::to_kdl(msg.twist.angular);
}
inline geometry_msgs::msg::WrenchStamped toMsg(const Stamped<KDL::Wrench>& in) {
  geometry_msgs::msg::WrenchStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  impl::from_kdl(in.force, out.wrench.force);
  impl::from_kdl(in.torque, out.wrench.torque);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::WrenchStamped& msg, Stamped<KDL::Wrench>& out) {
  impl::take_header(msg, out);
  out.force = impl::to_kdl(msg.wrench.force);
  out.torque = impl::to_kdl(msg.wrench.torque);
}
inline geometry_msgs::msg::Pose toMsg(const KDL::Frame& in) {
  geometry_msgs::msg::Pose out;
  impl::from_kdl(in.p, out.position);
  impl::from_kdl(in.M, out.orientation);
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Pose& msg, KDL::Frame& out) {
  out = KDL::Frame(impl::to_kdl(msg.orientation), impl::to_kdl(msg.position));
}
inline geometry_msgs::msg::PoseStamped toMsg(const Stamped<KDL::Frame>& in) {
  geometry_msgs::msg::PoseStamped out;
  impl::set_header(in.stamp_, in.frame_id_, out);
  out.pose = toMsg(static_cast<const KDL::Frame&>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::PoseStamped& msg, Stamped<KDL::Frame>& out) {
  impl::take_header(msg, out);
  fromMsg(msg.pose, static_cast<KDL::Frame&>(out));
}

// --- seen from another frame --------------------------------------------------------------------

template <>
inline void doTransform(const Stamped<KDL::Vector>& t_in, Stamped<KDL::Vector>& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::seen_from(t_in, t_out, transform);
}
template <>
inline void doTransform(const Stamped<KDL::Twist>& t_in, Stamped<KDL::Twist>& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::seen_from(t_in, t_out, transform);
}
template <>
inline void doTransform(const Stamped<KDL::Wrench>& t_in, Stamped<KDL::Wrench>& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::seen_from(t_in, t_out, transform);
}
template <>
inline void doTransform(const Stamped<KDL::Frame>& t_in, Stamped<KDL::Frame>& t_out,
                        const geometry_msgs::msg::TransformStamped& transform) {
  impl::seen_from(t_in, t_out, transform);
}

}  // namespace tf2
