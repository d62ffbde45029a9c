// The linear algebra of tf2: known answers, and laws that hold for any rotation.

// Compatibility, works: tf2: linear algebra, the buffer with its interpolation, static frames, new
// parents, requests, errors with the texts of ROS 2

// Compatibility, differs: yaw, pitch and roll of a rotation that looks straight up or down
// (`Matrix3x3::getRPY`, `tf2::getEulerYPR`) -> angles of that very rotation; those of ROS 2 are of
// another one

#include <gtest/gtest.h>

#include <random>

#include "tf2/LinearMath/Transform.hpp"

namespace {

using tf2::Matrix3x3;
using tf2::Quaternion;
using tf2::Transform;
using tf2::Vector3;

constexpr double kNear = 1e-9;

void expect_near(const Vector3& a, const Vector3& b) {
  EXPECT_NEAR(a.x(), b.x(), kNear);
  EXPECT_NEAR(a.y(), b.y(), kNear);
  EXPECT_NEAR(a.z(), b.z(), kNear);
}

// The same rotation: a quaternion and its opposite are.
void expect_same_rotation(const Quaternion& a, const Quaternion& b) {
  EXPECT_NEAR(std::abs(a.normalized().dot(b.normalized())), 1, kNear);
}

Quaternion from_rpy(double roll, double pitch, double yaw) {
  Quaternion q;
  q.setRPY(roll, pitch, yaw);
  return q;
}

class Random {
 public:
  double number(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  Vector3 vector() { return {number(-5, 5), number(-5, 5), number(-5, 5)}; }
  Quaternion rotation() { return Quaternion(vector(), number(-6, 6)); }
  Transform transform() { return Transform(rotation(), vector()); }

 private:
  std::mt19937 engine_{1};
};

constexpr int kTimes = 200;

TEST(Tf2Vector, KnownAnswers) {
  const Vector3 x(1, 0, 0);
  const Vector3 y(0, 1, 0);
  expect_near(x.cross(y), Vector3(0, 0, 1));
  EXPECT_DOUBLE_EQ(Vector3(1, 2, 3).dot(Vector3(4, 5, 6)), 32);
  EXPECT_DOUBLE_EQ(Vector3(3, 4, 12).length(), 13);
  EXPECT_DOUBLE_EQ(x.angle(y), TF2SIMD_HALF_PI);
  EXPECT_DOUBLE_EQ(Vector3(1, 1, 1).distance(Vector3(1, 4, 5)), 5);
  expect_near(x.rotate(Vector3(0, 0, 1), TF2SIMD_HALF_PI), y);
  expect_near(x.lerp(y, 0.25), Vector3(0.75, 0.25, 0));
  EXPECT_EQ(Vector3(1, -2, 3).minAxis(), 1);
  EXPECT_EQ(Vector3(1, -2, 3).maxAxis(), 2);
  EXPECT_EQ(Vector3(1, -7, 3).closestAxis(), 1);
  EXPECT_EQ(Vector3(4, 5, 6)[2], 6);
  EXPECT_DOUBLE_EQ(tf2NormalizeAngle(3.5 * TF2SIMD_PI), -TF2SIMD_HALF_PI);
}

TEST(Tf2Quaternion, KnownAnswers) {
  const Quaternion yaw = from_rpy(0, 0, TF2SIMD_HALF_PI);
  EXPECT_NEAR(yaw.z(), TF2SIMDSQRT12, kNear);
  EXPECT_NEAR(yaw.w(), TF2SIMDSQRT12, kNear);
  expect_near(quatRotate(yaw, Vector3(1, 0, 0)), Vector3(0, 1, 0));
  // Fixed axes: first the roll brings y to z, then the yaw leaves it there.
  expect_near(quatRotate(from_rpy(TF2SIMD_HALF_PI, 0, TF2SIMD_HALF_PI), Vector3(0, 1, 0)),
              Vector3(0, 0, 1));
  // Yaw about y, as setEuler has it.
  Quaternion euler;
  euler.setEuler(TF2SIMD_HALF_PI, 0, 0);
  expect_near(quatRotate(euler, Vector3(0, 0, 1)), Vector3(1, 0, 0));
  EXPECT_NEAR(yaw.getAngle(), TF2SIMD_HALF_PI, kNear);
  expect_near(yaw.getAxis(), Vector3(0, 0, 1));
  expect_near(Quaternion::getIdentity().getAxis(), Vector3(1, 0, 0));
  EXPECT_NEAR(Quaternion::getIdentity().angleShortestPath(yaw), TF2SIMD_HALF_PI, kNear);
  EXPECT_NEAR(Quaternion::getIdentity().angle(yaw), TF2SIMD_HALF_PI / 2, kNear);
  EXPECT_NEAR((-yaw).getAngleShortestPath(), TF2SIMD_HALF_PI, kNear);
}

TEST(Tf2Quaternion, InterpolatesAtEvenSpeedTheShortWay) {
  const Quaternion from = from_rpy(0, 0, 0.2);
  const Quaternion to = from_rpy(0, 0, 1.4);
  expect_same_rotation(from.slerp(to, 0.25), from_rpy(0, 0, 0.5));
  expect_same_rotation(from.slerp(-to, 0.25), from_rpy(0, 0, 0.5));
  expect_same_rotation(from.slerp(to, 0), from);
  expect_same_rotation(from.slerp(to, 1), to);
  EXPECT_EQ(from.slerp(from, 0.5), from);
}

TEST(Tf2Quaternion, ShortestArcTakesOneDirectionToTheOther) {
  Random random;
  for (int i = 0; i < kTimes; ++i) {
    Vector3 a = random.vector();
    Vector3 b = random.vector();
    const Quaternion arc = shortestArcQuatNormalize2(a, b);
    expect_near(quatRotate(arc, a), b);
  }
  const Vector3 up(0, 0, 1);
  expect_near(quatRotate(tf2::shortestArcQuat(up, -up), up), -up);
}

TEST(Tf2Rotation, ProductsAndInversesAgreeInAllForms) {
  Random random;
  for (int i = 0; i < kTimes; ++i) {
    const Quaternion q1 = random.rotation();
    const Quaternion q2 = random.rotation();
    const Vector3 v = random.vector();
    const Vector3 expected = quatRotate(q1, quatRotate(q2, v));
    expect_near(quatRotate(q1 * q2, v), expected);
    expect_near(Matrix3x3(q1) * Matrix3x3(q2) * v, expected);
    expect_near(Matrix3x3(q1 * q2) * v, expected);
    expect_near(v * Matrix3x3(q1).transpose(), quatRotate(q1, v));
    expect_near(quatRotate(q1.inverse(), quatRotate(q1, v)), v);
    expect_near(Matrix3x3(q1).inverse() * (Matrix3x3(q1) * v), v);
    EXPECT_NEAR(Matrix3x3(q1).determinant(), 1, kNear);
    EXPECT_NEAR(quatRotate(q1, v).length(), v.length(), kNear);
    Quaternion back;
    Matrix3x3(q1).getRotation(back);
    expect_same_rotation(back, q1);
    // Any length will do for a matrix.
    expect_near(Matrix3x3(q1 * 3.0) * v, quatRotate(q1, v));
  }
}

TEST(Tf2Rotation, RollPitchYawGoRound) {
  Random random;
  for (int i = 0; i < kTimes; ++i) {
    const double rpy[3] = {random.number(-3.1, 3.1), random.number(-1.5, 1.5),
                           random.number(-3.1, 3.1)};
    const Matrix3x3 matrix(from_rpy(rpy[0], rpy[1], rpy[2]));
    double roll = 0;
    double pitch = 0;
    double yaw = 0;
    matrix.getRPY(roll, pitch, yaw);
    EXPECT_NEAR(roll, rpy[0], kNear);
    EXPECT_NEAR(pitch, rpy[1], kNear);
    EXPECT_NEAR(yaw, rpy[2], kNear);
    Matrix3x3 again;
    again.setRPY(roll, pitch, yaw);
    expect_near(again * Vector3(1, 2, 3), matrix * Vector3(1, 2, 3));
    // The second solution is other angles for the same rotation.
    matrix.getRPY(roll, pitch, yaw, 2);
    EXPECT_GT(std::abs(pitch - rpy[1]), 1e-3);
    again.setRPY(roll, pitch, yaw);
    expect_near(again * Vector3(1, 2, 3), matrix * Vector3(1, 2, 3));
  }
}

TEST(Tf2Rotation, StraightUpAndDownHaveNoYaw) {
  for (const double sign : {1.0, -1.0}) {
    // Exactly: the last row begins with -1 or 1.
    const Matrix3x3 matrix(0, sign * std::sin(0.3), sign * std::cos(0.3), 0, std::cos(0.3),
                           -std::sin(0.3), -sign, 0, 0);
    double roll = 0;
    double pitch = 0;
    double yaw = 1;
    matrix.getRPY(roll, pitch, yaw);
    EXPECT_DOUBLE_EQ(pitch, sign * TF2SIMD_HALF_PI);
    EXPECT_DOUBLE_EQ(roll, 0.3);
    EXPECT_EQ(yaw, 0);
  }
}

TEST(Tf2Matrix, DiagonalizeKeepsTheMatrix) {
  const Matrix3x3 before(4, 1, -2, 1, 3, 0.5, -2, 0.5, 5);
  Matrix3x3 diagonal = before;
  Matrix3x3 rotation;
  diagonal.diagonalize(rotation, 1e-12, 50);
  EXPECT_NEAR(diagonal[0][1], 0, kNear);
  EXPECT_NEAR(diagonal[0][2], 0, kNear);
  EXPECT_NEAR(diagonal[1][2], 0, kNear);
  const Matrix3x3 again = (rotation * diagonal).timesTranspose(rotation);
  for (int row = 0; row < 3; ++row) {
    expect_near(again[row], before[row]);
  }
}

TEST(Tf2Matrix, OfOpenGl) {
  Random random;
  const Transform transform = random.transform();
  double columns[16];
  transform.getOpenGLMatrix(columns);
  EXPECT_EQ(columns[12], transform.getOrigin().x());
  EXPECT_EQ(columns[1], transform.getBasis()[1][0]);
  EXPECT_EQ(columns[15], 1);
  Transform back;
  back.setFromOpenGLMatrix(columns);
  EXPECT_EQ(back, transform);
}

TEST(Tf2Transform, ComposesAndInverts) {
  Random random;
  for (int i = 0; i < kTimes; ++i) {
    const Transform a = random.transform();
    const Transform b = random.transform();
    const Vector3 v = random.vector();
    expect_near((a * b) * v, a * (b * v));
    expect_near(a.inverse() * (a * v), v);
    expect_near(a.invXform(a * v), v);
    expect_near(a.inverseTimes(b) * v, a.inverse() * (b * v));
    Transform product = a;
    product *= b;
    expect_near(product * v, a * (b * v));
    expect_same_rotation((a * b).getRotation(), a.getRotation() * b.getRotation());
    tf2::TransformData stored;
    a.serialize(stored);
    Transform back;
    back.deSerialize(stored);
    EXPECT_EQ(back, a);
  }
  expect_near(Transform::getIdentity() * Vector3(1, 2, 3), Vector3(1, 2, 3));
}

}  // namespace
