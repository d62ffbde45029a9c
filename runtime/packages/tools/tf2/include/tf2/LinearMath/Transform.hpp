// A rotation and a translation: where one frame stands in another.
#pragma once

#include "tf2/LinearMath/Matrix3x3.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Vector3.hpp"

namespace tf2 {

#define TransformData TransformDoubleData

struct TransformFloatData {
  Matrix3x3FloatData m_basis;
  Vector3FloatData m_origin;
};
struct TransformDoubleData {
  Matrix3x3DoubleData m_basis;
  Vector3DoubleData m_origin;
};

class Transform {
 public:
  /// Not initialised.
  Transform() {}
  explicit Transform(const Quaternion& q, const Vector3& c = Vector3(0, 0, 0))
      : m_basis(q), m_origin(c) {}
  explicit Transform(const Matrix3x3& b, const Vector3& c = Vector3(0, 0, 0))
      : m_basis(b), m_origin(c) {}
  static const Transform& getIdentity() {
    static const Transform identity(Matrix3x3::getIdentity());
    return identity;
  }

  Matrix3x3& getBasis() { return m_basis; }
  const Matrix3x3& getBasis() const { return m_basis; }
  Vector3& getOrigin() { return m_origin; }
  const Vector3& getOrigin() const { return m_origin; }
  Quaternion getRotation() const {
    Quaternion q;
    m_basis.getRotation(q);
    return q;
  }
  void setBasis(const Matrix3x3& basis) { m_basis = basis; }
  void setOrigin(const Vector3& origin) { m_origin = origin; }
  void setRotation(const Quaternion& q) { m_basis.setRotation(q); }
  void setIdentity() { *this = getIdentity(); }
  /// 16 numbers, column by column.
  void setFromOpenGLMatrix(const tf2Scalar* m) {
    m_basis.setFromOpenGLSubMatrix(m);
    m_origin = Vector3(m[12], m[13], m[14]);
  }
  void getOpenGLMatrix(tf2Scalar* m) const {
    m_basis.getOpenGLSubMatrix(m);
    std::copy(m_origin.m_floats, m_origin.m_floats + 3, m + 12);
    m[15] = 1;
  }

  Vector3 operator()(const Vector3& x) const { return m_basis * x + m_origin; }
  Vector3 operator*(const Vector3& x) const { return (*this)(x); }
  Quaternion operator*(const Quaternion& q) const { return getRotation() * q; }
  Transform operator*(const Transform& t) const {
    return Transform(m_basis * t.m_basis, (*this)(t.m_origin));
  }
  Transform& operator*=(const Transform& t) { return *this = *this * t; }
  void mult(const Transform& t1, const Transform& t2) { *this = t1 * t2; }
  Transform inverse() const {
    const Matrix3x3 back = m_basis.transpose();
    return Transform(back, back * -m_origin);
  }
  /// inverse() * t
  Transform inverseTimes(const Transform& t) const { return inverse() * t; }
  /// inverse() * inVec
  Vector3 invXform(const Vector3& inVec) const { return m_basis.transpose() * (inVec - m_origin); }

  void serialize(TransformData& out) const { serializeDouble(out); }
  void deSerialize(const TransformData& in) { deSerializeDouble(in); }
  void serializeDouble(TransformDoubleData& out) const {
    m_basis.serializeDouble(out.m_basis);
    m_origin.serializeDouble(out.m_origin);
  }
  void deSerializeDouble(const TransformDoubleData& in) {
    m_basis.deSerializeDouble(in.m_basis);
    m_origin.deSerializeDouble(in.m_origin);
  }
  void serializeFloat(TransformFloatData& out) const {
    m_basis.serializeFloat(out.m_basis);
    m_origin.serializeFloat(out.m_origin);
  }
  void deSerializeFloat(const TransformFloatData& in) {
    m_basis.deSerializeFloat(in.m_basis);
    m_origin.deSerializeFloat(in.m_origin);
  }

 private:
  Matrix3x3 m_basis;
  Vector3 m_origin;
};

inline bool operator==(const Transform& t1, const Transform& t2) {
  return t1.getBasis() == t2.getBasis() && t1.getOrigin() == t2.getOrigin();
}

}  // namespace tf2
