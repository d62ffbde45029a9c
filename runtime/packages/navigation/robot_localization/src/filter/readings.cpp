// See readings.hpp.
#include "filter/readings.hpp"

#include <limits>
#include <utility>

namespace robot_localization {
namespace {

/// The variables that hold a part of the measured ones after a rotation, of three from `begin` on.
void rotate_update(const Eigen::Matrix3d& rotation, int begin, Variables& update) {
  constexpr double kLeast = 1e-12;  // of a squared length
  Variables rotated = update;
  for (int i = 0; i < 3; ++i) {
    double length = 0.0;
    for (int j = 0; j < 3; ++j) {
      if (update[begin + j]) length += rotation(i, j) * rotation(i, j);
    }
    rotated[begin + i] = length >= kLeast;
  }
  update = rotated;
}

/// Leaves out variables, from `begin` on, whose value or variance is not finite: a rotation would
/// spread them over the others.
template <typename Values, typename Matrix>
void leave_out_infinite(Values&& values, Matrix& covariance, int begin, Variables& update) {
  for (int i = 0; i < static_cast<int>(values.size()); ++i) {
    if (std::isfinite(values(i)) && std::isfinite(covariance(i, i))) continue;
    update.reset(begin + i);
    values(i) = 0.0;
    covariance(i, i) = 0.0;
  }
  covariance = covariance.unaryExpr([](double x) { return std::isfinite(x) ? x : 0.0; }).eval();
}

bool lacks(const Eigen::Vector3d& place, const Variables& wanted) {
  for (int i = 0; i < 3; ++i) {
    if (wanted[kX + i] && !std::isfinite(place(i))) return true;
  }
  return false;
}

Matrix6 rotated(const Matrix6& covariance, const Eigen::Matrix3d& rotation) {
  Matrix6 both = Matrix6::Zero();
  both.topLeftCorner<3, 3>() = rotation;
  both.bottomRightCorner<3, 3>() = rotation;
  const Matrix6 half = both.lazyProduct(covariance);
  return half.lazyProduct(both.transpose());
}

}  // namespace

void force_two_d(Measurement& measurement) {
  constexpr double kVariance = 1e-6;
  for (const int member : {kZ, kRoll, kPitch, kVz, kVroll, kVpitch, kAz}) {
    measurement.values(member) = 0.0;
    measurement.covariance(member, member) = kVariance;
    measurement.update.set(member);
  }
}

void take_twist(const TwistReading& reading, const Turning& turning, Measurement& measurement) {
  const Eigen::Matrix3d rotation = reading.base_from_sensor.linear();
  Vector6 velocity;
  velocity << reading.linear, reading.angular;
  Matrix6 covariance = reading.covariance;
  leave_out_infinite(velocity, covariance, kVx, measurement.update);
  rotate_update(rotation, kVx, measurement.update);
  rotate_update(rotation, kVroll, measurement.update);
  measurement.values.segment<3>(kVx) =
      rotation * velocity.head<3>() +
      reading.base_from_sensor.translation().cross(turning.velocity);
  measurement.values.segment<3>(kVroll) = rotation * velocity.tail<3>();
  measurement.covariance.block<6, 6>(kVx, kVx) = rotated(covariance, rotation);
}

void take_acceleration(const AccelerationReading& reading, const Turning& turning,
                       Measurement& measurement) {
  const Eigen::Matrix3d rotation = reading.base_from_sensor.linear();
  const Eigen::Vector3d arm = reading.base_from_sensor.translation();
  Eigen::Vector3d acceleration = reading.acceleration - reading.gravity;
  Eigen::Matrix3d covariance = reading.covariance;
  leave_out_infinite(acceleration, covariance, kAx, measurement.update);
  rotate_update(rotation, kAx, measurement.update);
  measurement.values.segment<3>(kAx) = rotation * acceleration + arm.cross(turning.acceleration) -
                                       arm.cross(turning.velocity).cross(turning.velocity);
  measurement.covariance.block<3, 3>(kAx, kAx) = rotation * covariance * rotation.transpose();
}

bool PoseSource::take(const PoseReading& reading, const Turning& turning,
                      Measurement& measurement) {
  const Eigen::Matrix3d rotation = reading.is_imu
                                       ? only_yaw(reading.target_from_message.linear())
                                       : Eigen::Matrix3d(reading.target_from_message.linear());
  Vector6 values;
  values << reading.pose.translation(), roll_pitch_yaw(reading.pose.linear());
  Eigen::Isometry3d pose = reading.pose;
  const bool has_rotation = pose.linear().allFinite();
  if (!has_rotation) {
    // Its angles need not be NaN, too: those of std::asin are clamped.
    values.tail<3>().setConstant(std::numeric_limits<double>::quiet_NaN());
    pose.linear().setIdentity();
  }
  Matrix6 covariance = reading.covariance;
  const Variables wanted = measurement.update & kPoseVariables;
  Variables known = kPoseVariables;
  leave_out_infinite(values, covariance, kX, known);
  const Eigen::Vector3d place = reading.pose.translation();
  for (int i = 0; i < 3; ++i) {
    // A place whose variance is infinite is not measured, but later poses may count from it.
    if (!std::isfinite(place(i))) pose.translation()(i) = 0.0;
  }
  measurement.update &= known | ~kPoseVariables;
  rotate_update(rotation, kX, measurement.update);
  rotate_update(rotation, kRoll, measurement.update);
  if (reading.child_from_base) {
    covariance = rotated(covariance, reading.child_from_base->linear().transpose());
  }
  covariance = rotated(covariance, rotation);

  Eigen::Isometry3d target_from_message = reading.target_from_message;
  if (reading.is_imu) {
    pose.linear() = without_mounting(pose.linear(), target_from_message.linear());
    target_from_message.setIdentity();
  }
  if (reading.is_differential) {
    // Without a rotation the way has no direction.
    if (!has_rotation) return false;
    return take_difference(reading, {pose, covariance, measurement.time_ns, known}, turning,
                           measurement);
  }
  if (reading.child_from_base) pose = pose * *reading.child_from_base;
  if (reading.is_relative) {
    // Every later pose counts from the first, so that one needs a rotation and the wanted places.
    if (!first_ && (!has_rotation || lacks(place, wanted))) return false;
    if (!first_) first_ = pose;
    pose = first_->inverse() * pose;
  }
  pose = target_from_message * pose;
  measurement.values.segment<3>(kX) = pose.translation();
  measurement.values.segment<3>(kRoll) = roll_pitch_yaw(pose.linear());
  measurement.covariance.topLeftCorner<6, 6>() = covariance;
  return true;
}

bool PoseSource::take_difference(const PoseReading& reading, const Timed& now,
                                 const Turning& turning, Measurement& measurement) {
  const std::optional<Timed> previous = std::exchange(previous_, now);
  if (!previous || now.time_ns <= previous->time_ns) return false;
  // A value that was unknown at one of the two times has no difference.
  const Variables changed = now.known ^ previous->known;
  for (const int begin : {kX, kRoll}) {
    if ((changed & three_from(begin)).any()) measurement.update &= ~three_from(begin);
  }
  const double dt = static_cast<double>(now.time_ns - previous->time_ns) * 1e-9;
  const Eigen::Isometry3d way = previous->pose.inverse() * now.pose;
  TwistReading twist;
  twist.linear = way.translation() / dt;
  twist.angular = roll_pitch_yaw(way.linear()) / dt;
  twist.covariance = (now.covariance + previous->covariance) * dt;
  if (reading.child_from_base) twist.base_from_sensor = reading.child_from_base->inverse();
  // The velocities are measured now, in place of the pose.
  measurement.update = (measurement.update & kPoseVariables) << kVx;
  take_twist(twist, turning, measurement);
  return true;
}

Eigen::Matrix3d without_mounting(const Eigen::Matrix3d& imu, const Eigen::Matrix3d& base_from_imu) {
  const Eigen::Vector3d mounting = roll_pitch_yaw(base_from_imu);
  Eigen::Vector3d angles = roll_pitch_yaw(imu) - mounting;
  for (double& angle : angles) angle = wrapped(angle);
  angles = Eigen::AngleAxisd(mounting.z(), Eigen::Vector3d::UnitZ()) * angles;
  return quaternion_of(angles.x(), angles.y(), angles.z()).toRotationMatrix();
}

Eigen::Vector3d gravity_in(const Eigen::Matrix3d& world_from_sensor, double gravity) {
  return world_from_sensor.transpose() * Eigen::Vector3d(0.0, 0.0, gravity);
}

}  // namespace robot_localization
