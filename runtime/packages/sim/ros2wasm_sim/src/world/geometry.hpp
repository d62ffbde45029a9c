// Positions, rotations and poses in metres and radians. Quaternions are of unit length.
#pragma once

#include <cmath>

namespace ros2wasm_sim {

struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Vector3&) const = default;
};

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator*(double s, const Vector3& v) {
  return {s * v.x, s * v.y, s * v.z};
}
inline double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vector3& v) {
  return std::sqrt(dot(v, v));
}

struct Quaternion {
  double w = 1;
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Quaternion&) const = default;
};

inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Quaternion inverse(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

inline Vector3 rotate(const Quaternion& q, const Vector3& v) {
  const Vector3 axis{q.x, q.y, q.z};
  const Vector3 twice = 2.0 * cross(axis, v);
  return v + q.w * twice + cross(axis, twice);
}

/// About the fixed axes x, then y, then z, as SDF and URDF write it.
inline Quaternion from_roll_pitch_yaw(double roll, double pitch, double yaw) {
  const double cr = std::cos(roll / 2), sr = std::sin(roll / 2);
  const double cp = std::cos(pitch / 2), sp = std::sin(pitch / 2);
  const double cy = std::cos(yaw / 2), sy = std::sin(yaw / 2);
  return {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
          cr * cp * sy - sr * sp * cy};
}

/// The yaw of a rotation, as from_roll_pitch_yaw() takes it.
inline double yaw_of(const Quaternion& q) {
  return std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
}

struct Pose {
  Vector3 position;
  Quaternion orientation;

  bool operator==(const Pose&) const = default;
};

/// `inner`, given in the frame that `outer` is, in the frame of `outer`.
inline Pose operator*(const Pose& outer, const Pose& inner) {
  return {outer.position + rotate(outer.orientation, inner.position),
          outer.orientation * inner.orientation};
}
inline Pose inverse(const Pose& pose) {
  const Quaternion back = inverse(pose.orientation);
  return {rotate(back, -1.0 * pose.position), back};
}

}  // namespace ros2wasm_sim
