// Angles of whatever can become a quaternion.
#pragma once

#include "geometry_msgs/msg/quaternion.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Transform.hpp"
#include "tf2/convert.hpp"
#include "tf2/transform_datatypes.hpp"

namespace tf2 {

// Defined in tf2_geometry_msgs.
void fromMsg(const geometry_msgs::msg::Quaternion& in, Quaternion& out);

namespace impl {

inline Quaternion toQuaternion(const Quaternion& q) {
  return q;
}
inline Quaternion toQuaternion(const geometry_msgs::msg::Quaternion& q) {
  return {q.x, q.y, q.z, q.w};
}
inline Quaternion toQuaternion(const geometry_msgs::msg::QuaternionStamped& q) {
  return toQuaternion(q.quaternion);
}
template <typename T>
Quaternion toQuaternion(const Stamped<T>& t) {
  geometry_msgs::msg::QuaternionStamped message = toMsg(t);
  return toQuaternion(message);
}
template <typename T>
Quaternion toQuaternion(const T& t) {
  geometry_msgs::msg::Quaternion message = toMsg(t);
  return toQuaternion(message);
}

}  // namespace impl

/// Yaw about z, pitch about the new y, roll about the new x. The quaternion may have any length.
template <class A>
void getEulerYPR(const A& a, double& yaw, double& pitch, double& roll) {
  const Quaternion q = impl::toQuaternion(a).normalized();
  // Within about a quarter of a degree of straight up or down, yaw and roll turn about the same
  // axis: all of it counts as yaw.
  const double sine = 2 * (q.w() * q.y() - q.x() * q.z());
  if (tf2Fabs(sine) >= 0.99999) {
    const double up = sine < 0 ? -1 : 1;
    pitch = up * TF2SIMD_HALF_PI;
    roll = 0;
    yaw = -up * 2 * tf2Atan2(q.x(), q.w());
    return;
  }
  Matrix3x3(q).getEulerYPR(yaw, pitch, roll);
}

template <class A>
double getYaw(const A& a) {
  double yaw = 0;
  double pitch = 0;
  double roll = 0;
  getEulerYPR(a, yaw, pitch, roll);
  return yaw;
}

template <class A>
A getTransformIdentity() {
  A a;
  convert(Transform::getIdentity(), a);
  return a;
}

}  // namespace tf2
