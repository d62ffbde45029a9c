// See odometry.hpp.
#include "diff_drive_controller/odometry.hpp"

#include <cmath>

namespace diff_drive_controller {
namespace {

constexpr double kShortest = 1e-4;  ///< [s]: below it speeds are not estimated
constexpr double kStraight = 1e-6;  ///< [rad]: a smaller turn counts as none

}  // namespace

WheelSpeeds wheel_speeds(double linear, double angular, const WheelGeometry& geometry) {
  const double turn = angular * geometry.separation / 2.0;
  return {(linear - turn) / geometry.left_radius, (linear + turn) / geometry.right_radius};
}

Odometry::Odometry(size_t velocity_rolling_window_size)
    : window_(velocity_rolling_window_size), linear_mean_(window_), angular_mean_(window_) {}

void Odometry::init(int64_t time_ns) {
  reset_means();
  time_ns_ = time_ns;
}

double Odometry::seconds_until(int64_t time_ns) const {
  return static_cast<double>(time_ns - time_ns_) * 1e-9;
}

bool Odometry::was_set_back(int64_t time_ns) {
  const bool was = time_ns < time_ns_;
  if (was) init(time_ns);
  return was;
}

bool Odometry::update(double left_pos, double right_pos, int64_t time_ns) {
  const bool starts_again = was_set_back(time_ns);
  if (!starts_again && seconds_until(time_ns) < kShortest) return false;
  const double left_way = left_pos * wheels_.left_radius;
  const double right_way = right_pos * wheels_.right_radius;
  const double left = left_way - left_way_;
  const double right = right_way - right_way_;
  left_way_ = left_way;
  right_way_ = right_way;
  if (starts_again) return false;  // the wheels were set back too
  return updateFromVelocity(left, right, time_ns);
}

bool Odometry::updateFromVelocity(double left_vel, double right_vel, int64_t time_ns) {
  if (was_set_back(time_ns)) return false;
  const double dt = seconds_until(time_ns);
  if (dt < kShortest) return false;
  const double linear = (left_vel + right_vel) / 2.0;
  const double angular = (right_vel - left_vel) / wheels_.separation;
  integrate(linear, angular);
  time_ns_ = time_ns;
  linear_mean_.accumulate(linear / dt);
  angular_mean_.accumulate(angular / dt);
  linear_ = linear_mean_.getRollingMean();
  angular_ = angular_mean_.getRollingMean();
  return true;
}

void Odometry::updateOpenLoop(double linear, double angular, int64_t time_ns) {
  linear_ = linear;
  angular_ = angular;
  if (was_set_back(time_ns)) return;
  const double dt = seconds_until(time_ns);
  time_ns_ = time_ns;
  integrate(linear * dt, angular * dt);
}

void Odometry::integrate(double linear, double angular) {
  const double before = heading_;
  heading_ += angular;
  if (std::abs(angular) < kStraight) {
    x_ += linear * std::cos(before + angular / 2.0);
    y_ += linear * std::sin(before + angular / 2.0);
    return;
  }
  const double radius = linear / angular;
  x_ += radius * (std::sin(heading_) - std::sin(before));
  y_ -= radius * (std::cos(heading_) - std::cos(before));
}

void Odometry::resetOdometry() {
  x_ = y_ = heading_ = 0.0;
}

void Odometry::setWheelParams(double wheel_separation, double left_wheel_radius,
                              double right_wheel_radius) {
  wheels_ = {wheel_separation, left_wheel_radius, right_wheel_radius};
}

void Odometry::setVelocityRollingWindowSize(size_t velocity_rolling_window_size) {
  window_ = velocity_rolling_window_size;
  reset_means();
}

void Odometry::reset_means() {
  linear_mean_ = Mean(window_);
  angular_mean_ = Mean(window_);
}

}  // namespace diff_drive_controller
