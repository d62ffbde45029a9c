// Points and vectors in space.
#pragma once

#include <algorithm>

#include "tf2/LinearMath/MinMax.hpp"
#include "tf2/LinearMath/Scalar.hpp"

namespace tf2 {

#define Vector3Data Vector3DoubleData
#define Vector3DataName "Vector3DoubleData"

struct Vector3FloatData {
  float m_floats[4];
};
struct Vector3DoubleData {
  double m_floats[4];
};

class Vector3 {
 public:
  // The fourth number is not used.
  tf2Scalar m_floats[4];

  /// Not initialised.
  Vector3() {}
  Vector3(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z) : m_floats{x, y, z, 0} {}

  const tf2Scalar& getX() const { return m_floats[0]; }
  const tf2Scalar& getY() const { return m_floats[1]; }
  const tf2Scalar& getZ() const { return m_floats[2]; }
  const tf2Scalar& x() const { return m_floats[0]; }
  const tf2Scalar& y() const { return m_floats[1]; }
  const tf2Scalar& z() const { return m_floats[2]; }
  const tf2Scalar& w() const { return m_floats[3]; }
  void setX(tf2Scalar x) { m_floats[0] = x; }
  void setY(tf2Scalar y) { m_floats[1] = y; }
  void setZ(tf2Scalar z) { m_floats[2] = z; }
  void setW(tf2Scalar w) { m_floats[3] = w; }
  void setValue(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z) {
    *this = Vector3(x, y, z);
  }
  void setZero() { setValue(0, 0, 0); }
  /// With this, `vector[i]` works.
  operator tf2Scalar*() { return m_floats; }
  operator const tf2Scalar*() const { return m_floats; }

  bool operator==(const Vector3& other) const {
    return std::equal(m_floats, m_floats + 4, other.m_floats);
  }
  bool operator!=(const Vector3& other) const { return !(*this == other); }

  Vector3& operator+=(const Vector3& v) { return assign(x() + v.x(), y() + v.y(), z() + v.z()); }
  Vector3& operator-=(const Vector3& v) { return assign(x() - v.x(), y() - v.y(), z() - v.z()); }
  Vector3& operator*=(const Vector3& v) { return assign(x() * v.x(), y() * v.y(), z() * v.z()); }
  Vector3& operator*=(const tf2Scalar& s) { return assign(x() * s, y() * s, z() * s); }
  Vector3& operator/=(const tf2Scalar& s) { return *this *= 1 / s; }

  tf2Scalar dot(const Vector3& v) const { return x() * v.x() + y() * v.y() + z() * v.z(); }
  Vector3 cross(const Vector3& v) const {
    return {y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x()};
  }
  /// The volume that three vectors span.
  tf2Scalar triple(const Vector3& v1, const Vector3& v2) const { return dot(v1.cross(v2)); }
  tf2Scalar length2() const { return dot(*this); }
  tf2Scalar length() const { return tf2Sqrt(length2()); }
  tf2Scalar distance2(const Vector3& v) const {
    Vector3 between = v;
    between -= *this;
    return between.length2();
  }
  tf2Scalar distance(const Vector3& v) const { return tf2Sqrt(distance2(v)); }
  /// In radians, from 0 to pi.
  tf2Scalar angle(const Vector3& v) const {
    return tf2Acos(dot(v) / tf2Sqrt(length2() * v.length2()));
  }
  Vector3& normalize() { return *this /= length(); }
  Vector3 normalized() const {
    Vector3 unit = *this;
    return unit.normalize();
  }
  Vector3 absolute() const { return {tf2Fabs(x()), tf2Fabs(y()), tf2Fabs(z())}; }
  /// Turned about `wAxis`, whose length is one, by `angle` radians (Rodrigues' formula).
  Vector3 rotate(const Vector3& wAxis, tf2Scalar angle) const {
    const tf2Scalar along = wAxis.dot(*this) * (1 - tf2Cos(angle));
    const Vector3 sideways = wAxis.cross(*this);
    Vector3 turned = *this;
    turned *= tf2Cos(angle);
    turned +=
        {sideways.x() * tf2Sin(angle), sideways.y() * tf2Sin(angle), sideways.z() * tf2Sin(angle)};
    return turned += {wAxis.x() * along, wAxis.y() * along, wAxis.z() * along};
  }
  /// 0, 1 or 2 for x, y or z.
  int minAxis() const {
    const int first = x() < y() ? 0 : 1;
    return m_floats[first] < z() ? first : 2;
  }
  /// As minAxis.
  int maxAxis() const {
    const int first = x() < y() ? 1 : 0;
    return m_floats[first] < z() ? 2 : first;
  }
  int furthestAxis() const { return absolute().minAxis(); }
  int closestAxis() const { return absolute().maxAxis(); }
  /// `t` is 0 for this one and 1 for `v`.
  Vector3 lerp(const Vector3& v, const tf2Scalar& t) const {
    return {x() + (v.x() - x()) * t, y() + (v.y() - y()) * t, z() + (v.z() - z()) * t};
  }
  void setInterpolate3(const Vector3& v0, const Vector3& v1, tf2Scalar rt) {
    for (int i = 0; i < 3; ++i) {
      m_floats[i] = (1 - rt) * v0.m_floats[i] + rt * v1.m_floats[i];
    }
  }
  void setMax(const Vector3& other) {
    for (int i = 0; i < 4; ++i) {
      tf2SetMax(m_floats[i], other.m_floats[i]);
    }
  }
  void setMin(const Vector3& other) {
    for (int i = 0; i < 4; ++i) {
      tf2SetMin(m_floats[i], other.m_floats[i]);
    }
  }
  /// The rows of the matrix that does what a cross product with this vector does.
  void getSkewSymmetricMatrix(Vector3* v0, Vector3* v1, Vector3* v2) const {
    *v0 = {0, -z(), y()};
    *v1 = {z(), 0, -x()};
    *v2 = {-y(), x(), 0};
  }
  bool isZero() const { return x() == 0 && y() == 0 && z() == 0; }
  bool fuzzyZero() const { return length2() < TF2SIMD_EPSILON; }

  void serialize(Vector3Data& out) const { std::copy(m_floats, m_floats + 4, out.m_floats); }
  void deSerialize(const Vector3Data& in) { std::copy(in.m_floats, in.m_floats + 4, m_floats); }
  void serializeDouble(Vector3DoubleData& out) const { serialize(out); }
  void deSerializeDouble(const Vector3DoubleData& in) { deSerialize(in); }
  void serializeFloat(Vector3FloatData& out) const {
    std::transform(m_floats, m_floats + 4, out.m_floats,
                   [](tf2Scalar value) { return static_cast<float>(value); });
  }
  void deSerializeFloat(const Vector3FloatData& in) {
    std::copy(in.m_floats, in.m_floats + 4, m_floats);
  }

 private:
  Vector3& assign(tf2Scalar x, tf2Scalar y, tf2Scalar z) {
    m_floats[0] = x;
    m_floats[1] = y;
    m_floats[2] = z;
    return *this;
  }
};

inline Vector3 operator+(const Vector3& v1, const Vector3& v2) {
  return {v1.x() + v2.x(), v1.y() + v2.y(), v1.z() + v2.z()};
}
inline Vector3 operator-(const Vector3& v1, const Vector3& v2) {
  return {v1.x() - v2.x(), v1.y() - v2.y(), v1.z() - v2.z()};
}
inline Vector3 operator-(const Vector3& v) {
  return {-v.x(), -v.y(), -v.z()};
}
/// Each number with its like, as `/`.
inline Vector3 operator*(const Vector3& v1, const Vector3& v2) {
  return {v1.x() * v2.x(), v1.y() * v2.y(), v1.z() * v2.z()};
}
inline Vector3 operator/(const Vector3& v1, const Vector3& v2) {
  return {v1.x() / v2.x(), v1.y() / v2.y(), v1.z() / v2.z()};
}
inline Vector3 operator*(const Vector3& v, const tf2Scalar& s) {
  return {v.x() * s, v.y() * s, v.z() * s};
}
inline Vector3 operator*(const tf2Scalar& s, const Vector3& v) {
  return v * s;
}
inline Vector3 operator/(const Vector3& v, const tf2Scalar& s) {
  return v * (1 / s);
}
inline tf2Scalar tf2Dot(const Vector3& v1, const Vector3& v2) {
  return v1.dot(v2);
}
inline Vector3 tf2Cross(const Vector3& v1, const Vector3& v2) {
  return v1.cross(v2);
}
inline tf2Scalar tf2Triple(const Vector3& v1, const Vector3& v2, const Vector3& v3) {
  return v1.triple(v2, v3);
}
inline tf2Scalar tf2Distance(const Vector3& v1, const Vector3& v2) {
  return v1.distance(v2);
}
inline tf2Scalar tf2Distance2(const Vector3& v1, const Vector3& v2) {
  return v1.distance2(v2);
}
inline tf2Scalar tf2Angle(const Vector3& v1, const Vector3& v2) {
  return v1.angle(v2);
}
inline Vector3 lerp(const Vector3& v1, const Vector3& v2, const tf2Scalar& t) {
  return v1.lerp(v2, t);
}
/// Two directions that with `n`, whose length is one, make a right-handed system.
inline void tf2PlaneSpace1(const Vector3& n, Vector3& p, Vector3& q) {
  const Vector3 other = tf2Fabs(n.z()) > TF2SIMDSQRT12 ? Vector3(1, 0, 0) : Vector3(0, 0, 1);
  p = other.cross(n).normalized();
  q = n.cross(p);
}

class tf2Vector4 : public Vector3 {
 public:
  tf2Vector4() {}
  tf2Vector4(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z, const tf2Scalar& w)
      : Vector3(x, y, z) {
    setW(w);
  }
  tf2Scalar getW() const { return w(); }
  tf2Vector4 absolute4() const { return {tf2Fabs(x()), tf2Fabs(y()), tf2Fabs(z()), tf2Fabs(w())}; }
  int maxAxis4() const {
    return static_cast<int>(std::max_element(m_floats, m_floats + 4) - m_floats);
  }
  int minAxis4() const {
    return static_cast<int>(std::min_element(m_floats, m_floats + 4) - m_floats);
  }
  int closestAxis4() const { return absolute4().maxAxis4(); }
  using Vector3::setValue;
  void setValue(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z, const tf2Scalar& w) {
    setValue(x, y, z);
    setW(w);
  }
};

}  // namespace tf2
