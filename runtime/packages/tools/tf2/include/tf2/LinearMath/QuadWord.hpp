// Four numbers: what a quaternion is made of.
#pragma once

#include <algorithm>

#include "tf2/LinearMath/MinMax.hpp"
#include "tf2/LinearMath/Scalar.hpp"

namespace tf2 {

class QuadWord {
 public:
  /// Not initialised.
  QuadWord() {}
  QuadWord(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z) : m_floats{x, y, z, 0} {}
  QuadWord(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z, const tf2Scalar& w)
      : m_floats{x, y, z, w} {}

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
  /// With this, `word[i]` works.
  operator tf2Scalar*() { return m_floats; }
  operator const tf2Scalar*() const { return m_floats; }

  bool operator==(const QuadWord& other) const {
    return std::equal(m_floats, m_floats + 4, other.m_floats);
  }
  bool operator!=(const QuadWord& other) const { return !(*this == other); }

  /// The fourth number becomes zero.
  void setValue(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z) {
    setValue(x, y, z, 0);
  }
  void setValue(const tf2Scalar& x, const tf2Scalar& y, const tf2Scalar& z, const tf2Scalar& w) {
    *this = QuadWord(x, y, z, w);
  }
  void setMax(const QuadWord& other) {
    for (int i = 0; i < 4; ++i) {
      tf2SetMax(m_floats[i], other.m_floats[i]);
    }
  }
  void setMin(const QuadWord& other) {
    for (int i = 0; i < 4; ++i) {
      tf2SetMin(m_floats[i], other.m_floats[i]);
    }
  }

 protected:
  tf2Scalar m_floats[4];
};

}  // namespace tf2
