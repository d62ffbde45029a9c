// Rotations as matrices, row by row.
#pragma once

#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2/LinearMath/Vector3.hpp"

namespace tf2 {

#define Matrix3x3Data Matrix3x3DoubleData

struct Matrix3x3FloatData {
  Vector3FloatData m_el[3];
};
struct Matrix3x3DoubleData {
  Vector3DoubleData m_el[3];
};

class Matrix3x3 {
 public:
  /// Not initialised.
  Matrix3x3() {}
  explicit Matrix3x3(const Quaternion& q) { setRotation(q); }
  Matrix3x3(const tf2Scalar& xx, const tf2Scalar& xy, const tf2Scalar& xz, const tf2Scalar& yx,
            const tf2Scalar& yy, const tf2Scalar& yz, const tf2Scalar& zx, const tf2Scalar& zy,
            const tf2Scalar& zz)
      : m_el{{xx, xy, xz}, {yx, yy, yz}, {zx, zy, zz}} {}
  static const Matrix3x3& getIdentity() {
    static const Matrix3x3 identity(1, 0, 0, 0, 1, 0, 0, 0, 1);
    return identity;
  }

  Vector3 getColumn(int i) const { return {m_el[0][i], m_el[1][i], m_el[2][i]}; }
  const Vector3& getRow(int i) const { return m_el[i]; }
  Vector3& operator[](int i) { return m_el[i]; }
  const Vector3& operator[](int i) const { return m_el[i]; }

  void setValue(const tf2Scalar& xx, const tf2Scalar& xy, const tf2Scalar& xz, const tf2Scalar& yx,
                const tf2Scalar& yy, const tf2Scalar& yz, const tf2Scalar& zx, const tf2Scalar& zy,
                const tf2Scalar& zz) {
    *this = Matrix3x3(xx, xy, xz, yx, yy, yz, zx, zy, zz);
  }
  void setIdentity() { *this = getIdentity(); }
  /// The quaternion may have any length but zero.
  void setRotation(const Quaternion& q);
  void getRotation(Quaternion& q) const;
  /// About z, then the new y, then the new x.
  void setEulerYPR(tf2Scalar eulerZ, tf2Scalar eulerY, tf2Scalar eulerX);
  /// About x, y and z of the fixed frame, in this order.
  void setRPY(tf2Scalar roll, tf2Scalar pitch, tf2Scalar yaw) { setEulerYPR(yaw, pitch, roll); }
  /// Solution 1 has the pitch in [-pi/2, pi/2]; the other one is its mirror. Where yaw and roll
  /// turn about the same axis, yaw is zero.
  void getEulerYPR(tf2Scalar& yaw, tf2Scalar& pitch, tf2Scalar& roll,
                   unsigned int solution_number = 1) const;
  void getRPY(tf2Scalar& roll, tf2Scalar& pitch, tf2Scalar& yaw,
              unsigned int solution_number = 1) const {
    getEulerYPR(yaw, pitch, roll, solution_number);
  }
  /// The upper left part of a matrix of OpenGL: four numbers a column.
  void setFromOpenGLSubMatrix(const tf2Scalar* m) {
    *this = Matrix3x3(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]);
  }
  void getOpenGLSubMatrix(tf2Scalar* m) const {
    for (int column = 0; column < 3; ++column) {
      const Vector3 values = getColumn(column);
      std::copy(values.m_floats, values.m_floats + 3, m + 4 * column);
      m[4 * column + 3] = 0;
    }
  }

  Matrix3x3& operator*=(const Matrix3x3& m);
  /// Column by column with the numbers of `s`.
  Matrix3x3 scaled(const Vector3& s) const {
    return from_rows(m_el[0] * s, m_el[1] * s, m_el[2] * s);
  }
  tf2Scalar determinant() const { return m_el[0].triple(m_el[1], m_el[2]); }
  Matrix3x3 transpose() const { return from_rows(getColumn(0), getColumn(1), getColumn(2)); }
  /// Times this, it is the determinant times the identity.
  Matrix3x3 adjoint() const {
    return from_rows(m_el[1].cross(m_el[2]), m_el[2].cross(m_el[0]), m_el[0].cross(m_el[1]))
        .transpose();
  }
  Matrix3x3 absolute() const {
    return from_rows(m_el[0].absolute(), m_el[1].absolute(), m_el[2].absolute());
  }
  Matrix3x3 inverse() const {
    const tf2Scalar factor = 1 / determinant();
    return adjoint().scaled(Vector3(factor, factor, factor));
  }
  Matrix3x3 transposeTimes(const Matrix3x3& m) const;
  Matrix3x3 timesTranspose(const Matrix3x3& m) const;
  tf2Scalar tdotx(const Vector3& v) const { return getColumn(0).dot(v); }
  tf2Scalar tdoty(const Vector3& v) const { return getColumn(1).dot(v); }
  tf2Scalar tdotz(const Vector3& v) const { return getColumn(2).dot(v); }
  /// The determinant of two rows and two columns.
  tf2Scalar cofac(int r1, int c1, int r2, int c2) const {
    return m_el[r1][c1] * m_el[r2][c2] - m_el[r1][c2] * m_el[r2][c1];
  }
  /// Makes a symmetric matrix diagonal by rotations (Jacobi): before = rot * after * rot^T. Ends
  /// when what is off the diagonal is less than `threshold` of it.
  void diagonalize(Matrix3x3& rot, tf2Scalar threshold, int maxSteps);

  void serialize(Matrix3x3Data& out) const { serializeDouble(out); }
  void deSerialize(const Matrix3x3Data& in) { deSerializeDouble(in); }
  void serializeDouble(Matrix3x3DoubleData& out) const {
    for (int i = 0; i < 3; ++i) {
      m_el[i].serialize(out.m_el[i]);
    }
  }
  void deSerializeDouble(const Matrix3x3DoubleData& in) {
    for (int i = 0; i < 3; ++i) {
      m_el[i].deSerialize(in.m_el[i]);
    }
  }
  void serializeFloat(Matrix3x3FloatData& out) const {
    for (int i = 0; i < 3; ++i) {
      m_el[i].serializeFloat(out.m_el[i]);
    }
  }
  void deSerializeFloat(const Matrix3x3FloatData& in) {
    for (int i = 0; i < 3; ++i) {
      m_el[i].deSerializeFloat(in.m_el[i]);
    }
  }

 private:
  static Matrix3x3 from_rows(const Vector3& x, const Vector3& y, const Vector3& z) {
    return {x.x(), x.y(), x.z(), y.x(), y.y(), y.z(), z.x(), z.y(), z.z()};
  }

  Vector3 m_el[3];
};

inline Vector3 operator*(const Matrix3x3& m, const Vector3& v) {
  return {m[0].dot(v), m[1].dot(v), m[2].dot(v)};
}
inline Vector3 operator*(const Vector3& v, const Matrix3x3& m) {
  return m.transpose() * v;
}
inline Matrix3x3 operator*(const Matrix3x3& m1, const Matrix3x3& m2) {
  Matrix3x3 product;
  for (int row = 0; row < 3; ++row) {
    product[row] = m1[row] * m2;
  }
  return product;
}
inline bool operator==(const Matrix3x3& m1, const Matrix3x3& m2) {
  for (int row = 0; row < 3; ++row) {
    if (!std::equal(m1[row].m_floats, m1[row].m_floats + 3, m2[row].m_floats)) {
      return false;
    }
  }
  return true;
}

inline Matrix3x3& Matrix3x3::operator*=(const Matrix3x3& m) {
  return *this = *this * m;
}
inline Matrix3x3 Matrix3x3::transposeTimes(const Matrix3x3& m) const {
  return transpose() * m;
}
inline Matrix3x3 Matrix3x3::timesTranspose(const Matrix3x3& m) const {
  return *this * m.transpose();
}

inline void Matrix3x3::setRotation(const Quaternion& q) {
  // The columns are the three axes, turned: q e q^-1 with both products written out.
  const tf2Scalar s = 2 / q.length2();
  const Vector3 v(q.x(), q.y(), q.z());
  for (int column = 0; column < 3; ++column) {
    Vector3 axis(0, 0, 0);
    axis[column] = 1;
    const Vector3 around = v.cross(axis);
    const Vector3 turned = axis + around * (q.w() * s) + v.cross(around) * s;
    for (int row = 0; row < 3; ++row) {
      m_el[row][column] = turned[row];
    }
    m_el[column].setW(0);
  }
}

inline void Matrix3x3::getRotation(Quaternion& q) const {
  // Each of the four numbers has its square in the trace; the largest one gives the others.
  const tf2Scalar trace = m_el[0][0] + m_el[1][1] + m_el[2][2];
  tf2Scalar values[4];
  if (trace > 0) {
    const tf2Scalar four_w = 2 * tf2Sqrt(1 + trace);
    values[0] = (m_el[2][1] - m_el[1][2]) / four_w;
    values[1] = (m_el[0][2] - m_el[2][0]) / four_w;
    values[2] = (m_el[1][0] - m_el[0][1]) / four_w;
    values[3] = four_w / 4;
  } else {
    const int i = Vector3(m_el[0][0], m_el[1][1], m_el[2][2]).maxAxis();
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const tf2Scalar four = 2 * tf2Sqrt(1 + m_el[i][i] - m_el[j][j] - m_el[k][k]);
    values[i] = four / 4;
    values[j] = (m_el[j][i] + m_el[i][j]) / four;
    values[k] = (m_el[k][i] + m_el[i][k]) / four;
    values[3] = (m_el[k][j] - m_el[j][k]) / four;
  }
  q.setValue(values[0], values[1], values[2], values[3]);
}

inline void Matrix3x3::setEulerYPR(tf2Scalar eulerZ, tf2Scalar eulerY, tf2Scalar eulerX) {
  const tf2Scalar cz = tf2Cos(eulerZ), sz = tf2Sin(eulerZ);
  const tf2Scalar cy = tf2Cos(eulerY), sy = tf2Sin(eulerY);
  const tf2Scalar cx = tf2Cos(eulerX), sx = tf2Sin(eulerX);
  *this = Matrix3x3(cz, -sz, 0, sz, cz, 0, 0, 0, 1) * Matrix3x3(cy, 0, sy, 0, 1, 0, -sy, 0, cy) *
          Matrix3x3(1, 0, 0, 0, cx, -sx, 0, sx, cx);
}

inline void Matrix3x3::getEulerYPR(tf2Scalar& yaw, tf2Scalar& pitch, tf2Scalar& roll,
                                   unsigned int solution_number) const {
  // The last row is (-sin(pitch), cos(pitch) sin(roll), cos(pitch) cos(roll)).
  if (tf2Fabs(m_el[2][0]) >= 1) {
    const tf2Scalar up = m_el[2][0] < 0 ? 1 : -1;
    pitch = up * TF2SIMD_HALF_PI;
    roll = tf2Atan2(up * m_el[0][1], up * m_el[0][2]);
    yaw = 0;
    return;
  }
  pitch = -tf2Asin(m_el[2][0]);
  if (solution_number != 1) {
    pitch = TF2SIMD_PI - pitch;
  }
  const tf2Scalar cosine = tf2Cos(pitch);
  roll = tf2Atan2(m_el[2][1] / cosine, m_el[2][2] / cosine);
  yaw = tf2Atan2(m_el[1][0] / cosine, m_el[0][0] / cosine);
}

inline void Matrix3x3::diagonalize(Matrix3x3& rot, tf2Scalar threshold, int maxSteps) {
  rot.setIdentity();
  for (int step = 0; step < maxSteps; ++step) {
    // The largest number off the diagonal; it and its two axes.
    const Vector3 off(m_el[1][2], m_el[0][2], m_el[0][1]);
    const int third = off.closestAxis();
    const int p = third == 0 ? 1 : 0;
    const int q = third == 2 ? 1 : 2;
    const tf2Scalar diagonal = tf2Fabs(m_el[0][0]) + tf2Fabs(m_el[1][1]) + tf2Fabs(m_el[2][2]);
    if (tf2Fabs(m_el[p][q]) <= threshold * diagonal) {
      return;
    }
    // The turn in the plane of p and q that makes it zero.
    const tf2Scalar angle = tf2Atan2(2 * m_el[p][q], m_el[q][q] - m_el[p][p]) / 2;
    Matrix3x3 turn = getIdentity();
    turn[p][p] = turn[q][q] = tf2Cos(angle);
    turn[p][q] = tf2Sin(angle);
    turn[q][p] = -tf2Sin(angle);
    *this = turn.transposeTimes(*this) * turn;
    m_el[p][q] = m_el[q][p] = 0;
    rot *= turn;
  }
}

}  // namespace tf2
