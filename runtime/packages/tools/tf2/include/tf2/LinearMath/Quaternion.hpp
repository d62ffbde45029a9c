// Rotations as quaternions (x, y, z, w); those of length one are rotations.
#pragma once

#include "tf2/LinearMath/QuadWord.hpp"
#include "tf2/LinearMath/Vector3.hpp"

namespace tf2 {

class Quaternion : public QuadWord {
 public:
  /// Not initialised.
  Quaternion() {}
  Quaternion(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z, const tf2Scalar& w)
      : QuadWord(x, y, z, w) {}
  /// The axis may have any length but zero; the angle is in radians.
  Quaternion(const Vector3& axis, const tf2Scalar& angle) { setRotation(axis, angle); }
  static const Quaternion& getIdentity() {
    static const Quaternion identity(0, 0, 0, 1);
    return identity;
  }

  void setRotation(const Vector3& axis, const tf2Scalar& angle) {
    const Vector3 part = axis * (tf2Sin(angle / 2) / axis.length());
    setValue(part.x(), part.y(), part.z(), tf2Cos(angle / 2));
  }
  /// Yaw about y, then pitch about the new x, then roll about the new z.
  void setEuler(const tf2Scalar& yaw, const tf2Scalar& pitch, const tf2Scalar& roll);
  /// Roll about x, then pitch about y, then yaw about z, all of the fixed frame.
  void setRPY(const tf2Scalar& roll, const tf2Scalar& pitch, const tf2Scalar& yaw);

  const tf2Scalar& getW() const { return w(); }
  Quaternion& operator+=(const Quaternion& q) { return *this = *this + q; }
  Quaternion& operator-=(const Quaternion& q) { return *this = *this - q; }
  Quaternion& operator*=(const tf2Scalar& s) { return *this = *this * s; }
  Quaternion& operator/=(const tf2Scalar& s) { return *this = *this / s; }
  Quaternion& operator*=(const Quaternion& q);
  Quaternion operator+(const Quaternion& q) const {
    return {x() + q.x(), y() + q.y(), z() + q.z(), w() + q.w()};
  }
  Quaternion operator-(const Quaternion& q) const {
    return {x() - q.x(), y() - q.y(), z() - q.z(), w() - q.w()};
  }
  Quaternion operator-() const { return {-x(), -y(), -z(), -w()}; }
  Quaternion operator*(const tf2Scalar& s) const { return {x() * s, y() * s, z() * s, w() * s}; }
  Quaternion operator/(const tf2Scalar& s) const { return *this * (1 / s); }

  tf2Scalar dot(const Quaternion& q) const {
    return x() * q.x() + y() * q.y() + z() * q.z() + w() * q.w();
  }
  tf2Scalar length2() const { return dot(*this); }
  tf2Scalar length() const { return tf2Sqrt(length2()); }
  Quaternion& normalize() { return *this /= length(); }
  Quaternion normalized() const { return *this / length(); }
  /// The opposite rotation. The quaternion must have length one.
  Quaternion inverse() const { return {-x(), -y(), -z(), w()}; }

  /// Half of the angle of the rotation from this one to `q`.
  tf2Scalar angle(const Quaternion& q) const { return tf2Acos(cosine(q)); }
  /// The whole angle, the short way round.
  tf2Scalar angleShortestPath(const Quaternion& q) const { return 2 * tf2Acos(tf2Fabs(cosine(q))); }
  /// From 0 to 2 pi.
  tf2Scalar getAngle() const { return 2 * tf2Acos(w()); }
  /// From 0 to pi.
  tf2Scalar getAngleShortestPath() const { return 2 * tf2Acos(tf2Fabs(w())); }
  /// The axis, of length one; the x axis when there is no rotation.
  Vector3 getAxis() const {
    const tf2Scalar sine2 = 1 - w() * w();
    return sine2 < 10 * TF2SIMD_EPSILON ? Vector3(1, 0, 0)
                                        : Vector3(x(), y(), z()) / tf2Sqrt(sine2);
  }
  /// `qd` or its opposite, whichever is further away.
  Quaternion farthest(const Quaternion& qd) const { return dot(qd) < 0 ? qd : -qd; }
  Quaternion nearest(const Quaternion& qd) const { return dot(qd) < 0 ? -qd : qd; }
  /// At even speed the short way from this one (`t` = 0) to `q` (`t` = 1).
  Quaternion slerp(const Quaternion& q, const tf2Scalar& t) const {
    const tf2Scalar theta = angleShortestPath(q) / 2;
    if (theta == 0) {
      return *this;
    }
    const tf2Scalar from = tf2Sin((1 - t) * theta) / tf2Sin(theta);
    const tf2Scalar to = tf2Sin(t * theta) / tf2Sin(theta);
    return *this * from + nearest(q) * to;
  }

 private:
  tf2Scalar cosine(const Quaternion& q) const { return dot(q) / tf2Sqrt(length2() * q.length2()); }
};

inline Quaternion operator*(const Quaternion& q1, const Quaternion& q2) {
  const Vector3 v1(q1.x(), q1.y(), q1.z());
  const Vector3 v2(q2.x(), q2.y(), q2.z());
  const Vector3 v = v1.cross(v2) + v2 * q1.w() + v1 * q2.w();
  return {v.x(), v.y(), v.z(), q1.w() * q2.w() - v1.dot(v2)};
}
/// The vector counts as a quaternion without w.
inline Quaternion operator*(const Quaternion& q, const Vector3& v) {
  return q * Quaternion(v.x(), v.y(), v.z(), 0);
}
inline Quaternion operator*(const Vector3& v, const Quaternion& q) {
  return Quaternion(v.x(), v.y(), v.z(), 0) * q;
}
inline tf2Scalar dot(const Quaternion& q1, const Quaternion& q2) {
  return q1.dot(q2);
}
inline tf2Scalar length(const Quaternion& q) {
  return q.length();
}
inline tf2Scalar angle(const Quaternion& q1, const Quaternion& q2) {
  return q1.angle(q2);
}
inline tf2Scalar angleShortestPath(const Quaternion& q1, const Quaternion& q2) {
  return q1.angleShortestPath(q2);
}
inline Quaternion inverse(const Quaternion& q) {
  return q.inverse();
}
inline Quaternion slerp(const Quaternion& q1, const Quaternion& q2, const tf2Scalar& t) {
  return q1.slerp(q2, t);
}
/// `v` turned by `rotation`.
inline Vector3 quatRotate(const Quaternion& rotation, const Vector3& v) {
  const Quaternion turned = rotation * v * rotation.inverse();
  return {turned.x(), turned.y(), turned.z()};
}
/// The rotation that takes one direction to the other. Both have length one.
inline Quaternion shortestArcQuat(const Vector3& v0, const Vector3& v1) {
  const tf2Scalar cosine = v0.dot(v1);
  if (cosine < -1 + TF2SIMD_EPSILON) {
    // Half a turn, about any axis that stands upright on it.
    Vector3 axis;
    Vector3 unused;
    tf2PlaneSpace1(v0, axis, unused);
    return {axis.x(), axis.y(), axis.z(), 0};
  }
  const Vector3 axis = v0.cross(v1);
  return Quaternion(axis.x(), axis.y(), axis.z(), 1 + cosine).normalized();
}
inline Quaternion shortestArcQuatNormalize2(Vector3& v0, Vector3& v1) {
  return shortestArcQuat(v0.normalize(), v1.normalize());
}

inline Quaternion& Quaternion::operator*=(const Quaternion& q) {
  return *this = *this * q;
}
inline void Quaternion::setEuler(const tf2Scalar& yaw, const tf2Scalar& pitch,
                                 const tf2Scalar& roll) {
  *this = Quaternion(Vector3(0, 1, 0), yaw) * Quaternion(Vector3(1, 0, 0), pitch) *
          Quaternion(Vector3(0, 0, 1), roll);
}
inline void Quaternion::setRPY(const tf2Scalar& roll, const tf2Scalar& pitch,
                               const tf2Scalar& yaw) {
  *this = Quaternion(Vector3(0, 0, 1), yaw) * Quaternion(Vector3(0, 1, 0), pitch) *
          Quaternion(Vector3(1, 0, 0), roll);
}

}  // namespace tf2
