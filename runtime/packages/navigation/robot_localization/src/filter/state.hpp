// The 15 variables that a filter estimates, in the order of every `*_config` parameter. Without
// ROS.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>

namespace robot_localization {

/// The pose is in the world frame [m, rad]; velocities [m/s, rad/s] and accelerations [m/s^2] are
/// in the frame of the base.
enum StateMember : int {
  kX,
  kY,
  kZ,
  kRoll,
  kPitch,
  kYaw,
  kVx,
  kVy,
  kVz,
  kVroll,
  kVpitch,
  kVyaw,
  kAx,
  kAy,
  kAz,
};

constexpr int kStateSize = 15;
constexpr int kPoseSize = 6;   ///< position and orientation
constexpr int kTwistSize = 6;  ///< linear and angular velocity

using State = Eigen::Matrix<double, kStateSize, 1>;
using Covariance = Eigen::Matrix<double, kStateSize, kStateSize>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Variables = std::bitset<kStateSize>;

inline Variables three_from(int first) {
  return Variables(0b111UL << first);
}
inline const Variables kPoseVariables = three_from(kX) | three_from(kRoll);
inline const Variables kTwistVariables = three_from(kVx) | three_from(kVroll);

/// A covariance below it makes corrections unstable [the square of the variable's unit].
constexpr double kLeastVariance = 1e-9;

/// The same angle from -pi to pi.
inline double wrapped(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

inline void wrap_angles(State& state) {
  for (const int i : {kRoll, kPitch, kYaw}) state(i) = wrapped(state(i));
}

/// Roll, pitch and yaw; the pitch is from -pi/2 to pi/2.
inline Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation) {
  const double sine = std::min(1.0, std::max(-1.0, -rotation(2, 0)));
  return {std::atan2(rotation(2, 1), rotation(2, 2)), std::asin(sine),
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

/// The part of a rotation about the vertical.
inline Eigen::Matrix3d only_yaw(const Eigen::Matrix3d& rotation) {
  const double yaw = roll_pitch_yaw(rotation).z();
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

inline Eigen::Quaterniond quaternion_of(double roll, double pitch, double yaw) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

}  // namespace robot_localization
