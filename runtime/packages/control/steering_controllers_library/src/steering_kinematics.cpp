// See steering_kinematics.hpp.
#include "steering_controllers_library/steering_kinematics.hpp"

#include <algorithm>
#include <cmath>

namespace steering_kinematics {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kShortest = 1e-4;          ///< [s]: below it speeds are not estimated
constexpr double kAlmostZero = 1e-6;        ///< [rad]
constexpr double kReducedFrom = kPi / 6.0;  ///< [rad] between wanted and measured steering
constexpr double kReducedMost = 1.5608;     ///< [rad], just below a right angle

bool is_close_to_zero(double value) {
  return std::abs(value) < kAlmostZero;
}

}  // namespace

SteeringKinematics::SteeringKinematics(size_t velocity_rolling_window_size)
    : window_(velocity_rolling_window_size), linear_mean_(window_), angular_mean_(window_) {}

bool SteeringKinematics::update(double linear, double dt) {
  const double angular = std::tan(steer_pos_) * linear / base_;
  integrate(linear, angular, dt);
  if (dt < kShortest) return false;
  linear_mean_.accumulate(linear);
  angular_mean_.accumulate(angular);
  linear_ = linear_mean_.getRollingMean();
  angular_ = angular_mean_.getRollingMean();
  return true;
}

double SteeringKinematics::speed_of_axle(double right_wheel_vel, double left_wheel_vel) const {
  const double right = right_wheel_vel * radius_;
  const double left = left_wheel_vel * radius_;
  const double turn = base_ / std::tan(steer_pos_);
  if (std::isinf(turn)) return (right + left) / 2.0;
  // Each wheel tells the speed of the middle; the mean of both counts.
  return (right * turn / (turn + traction_track_ / 2.0) +
          left * turn / (turn - traction_track_ / 2.0)) /
         2.0;
}

bool SteeringKinematics::update_from_position(double traction_wheel_pos, double steer_pos,
                                              double dt) {
  const double way = traction_wheel_pos - right_pos_;
  right_pos_ = traction_wheel_pos;
  return update_from_velocity(way / dt, steer_pos, dt);
}

bool SteeringKinematics::update_from_position(double right_wheel_pos, double left_wheel_pos,
                                              double steer_pos, double dt) {
  const double right = right_wheel_pos - right_pos_;
  const double left = left_wheel_pos - left_pos_;
  right_pos_ = right_wheel_pos;
  left_pos_ = left_wheel_pos;
  return update_from_velocity(right / dt, left / dt, steer_pos, dt);
}

bool SteeringKinematics::update_from_position(double right_wheel_pos, double left_wheel_pos,
                                              double right_steer_pos, double left_steer_pos,
                                              double dt) {
  const double right = right_wheel_pos - right_pos_;
  const double left = left_wheel_pos - left_pos_;
  right_pos_ = right_wheel_pos;
  left_pos_ = left_wheel_pos;
  return update_from_velocity(right / dt, left / dt, right_steer_pos, left_steer_pos, dt);
}

bool SteeringKinematics::update_from_velocity(double traction_wheel_vel, double steer_pos,
                                              double dt) {
  steer_pos_ = steer_pos;
  return update(traction_wheel_vel * radius_, dt);
}

bool SteeringKinematics::update_from_velocity(double right_wheel_vel, double left_wheel_vel,
                                              double steer_pos, double dt) {
  steer_pos_ = steer_pos;
  return update(speed_of_axle(right_wheel_vel, left_wheel_vel), dt);
}

bool SteeringKinematics::update_from_velocity(double right_wheel_vel, double left_wheel_vel,
                                              double right_steer_pos, double left_steer_pos,
                                              double dt) {
  const auto middle = [this](double angle, double side) {
    const double slope = std::tan(angle);
    return std::atan(base_ * slope / (base_ - side * steering_track_ / 2.0 * slope));
  };
  steer_pos_ = (middle(right_steer_pos, 1.0) + middle(left_steer_pos, -1.0)) / 2.0;
  return update(speed_of_axle(right_wheel_vel, left_wheel_vel), dt);
}

void SteeringKinematics::update_open_loop(double v_bx, double omega_bz, double dt) {
  linear_ = v_bx;
  angular_ = omega_bz;
  integrate(v_bx, omega_bz, dt);
}

void SteeringKinematics::integrate(double linear, double angular, double dt) {
  const double way = linear * dt;
  const double turn = angular * dt;
  const double before = heading_;
  heading_ += turn;
  if (is_close_to_zero(turn)) {
    x_ += way * std::cos(before + turn / 2.0);
    y_ += way * std::sin(before + turn / 2.0);
    return;
  }
  x_ += way / turn * (std::sin(heading_) - std::sin(before));
  y_ -= way / turn * (std::cos(heading_) - std::cos(before));
}

void SteeringKinematics::set_wheel_params(double wheel_radius, double wheel_base,
                                          double wheel_track) {
  set_wheel_params(wheel_radius, wheel_base, wheel_track, wheel_track);
}

void SteeringKinematics::set_wheel_params(double wheel_radius, double wheel_base,
                                          double wheel_track_steering,
                                          double wheel_track_traction) {
  radius_ = wheel_radius;
  base_ = wheel_base;
  steering_track_ = wheel_track_steering;
  traction_track_ = wheel_track_traction;
}

void SteeringKinematics::set_velocity_rolling_window_size(size_t velocity_rolling_window_size) {
  window_ = velocity_rolling_window_size;
  reset_means();
}

void SteeringKinematics::reset_means() {
  linear_mean_ = Mean(window_);
  angular_mean_ = Mean(window_);
}

void SteeringKinematics::reset_odometry() {
  x_ = y_ = heading_ = 0.0;
  reset_means();
}

std::tuple<std::vector<double>, std::vector<double>> SteeringKinematics::get_commands(
    double v_bx, double omega_bz, bool open_loop,
    bool reduce_wheel_speed_until_steering_reached) const {
  double angle = std::atan(omega_bz * base_ / v_bx);
  if (!std::isfinite(angle)) angle = 0.0;  // it stands
  double speed = v_bx / radius_;
  if (!open_loop && reduce_wheel_speed_until_steering_reached) {
    const double off = std::abs(steer_pos_ - angle);
    if (off >= kReducedFrom) {
      speed *= std::cos(std::min(off, kReducedMost)) / std::cos(kReducedFrom);
    }
  }
  if (type_ == BICYCLE_CONFIG) return {{speed}, {angle}};

  // The driven wheels follow the steering that is reached, not the one that is wanted.
  const double reached = open_loop ? angle : steer_pos_;
  const bool is_straight = is_close_to_zero(reached);
  std::vector<double> traction = {speed, speed};
  if (!is_straight) {
    const double turn = base_ / std::tan(reached);
    traction = {speed * (turn + traction_track_ / 2.0) / turn,
                speed * (turn - traction_track_ / 2.0) / turn};
  }
  if (type_ == TRICYCLE_CONFIG) return {traction, {angle}};
  if (is_straight) return {traction, {angle, angle}};
  const double side = 2.0 * base_ * std::sin(angle);
  const double forward = 2.0 * base_ * std::cos(angle);
  const double track = steering_track_ * std::sin(angle);
  return {traction, {std::atan2(side, forward + track), std::atan2(side, forward - track)}};
}

}  // namespace steering_kinematics
