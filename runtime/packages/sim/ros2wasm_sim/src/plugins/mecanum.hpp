// Four wheels with rollers at 45 degrees: their speeds for a motion, and the motion of their
// angles.
#pragma once

#include <cmath>

#include "world/geometry.hpp"

namespace ros2wasm_sim {

struct MecanumSize {
  double wheel_separation = 1;  ///< metres, from left to right
  double wheel_base = 1;        ///< metres, from front to back
  double wheel_radius = 0.2;    ///< metres
  double arm() const { return (wheel_separation + wheel_base) / 2; }
};

/// Angles of the four wheels in radians, or speeds in rad/s.
struct MecanumWheels {
  double front_left = 0, front_right = 0, back_left = 0, back_right = 0;
};

/// Forward and left in m/s, turning in rad/s.
struct PlanarMotion {
  double forward = 0, left = 0, turn = 0;
};

inline MecanumWheels mecanum_wheels(const MecanumSize& size, const PlanarMotion& motion) {
  const double turn = size.arm() * motion.turn, radius = size.wheel_radius;
  return {(motion.forward - motion.left - turn) / radius,
          (motion.forward + motion.left + turn) / radius,
          (motion.forward + motion.left - turn) / radius,
          (motion.forward - motion.left + turn) / radius};
}

inline PlanarMotion mecanum_motion(const MecanumSize& size, const MecanumWheels& wheels) {
  const double quarter = size.wheel_radius / 4;
  return {
      quarter * (wheels.front_left + wheels.front_right + wheels.back_left + wheels.back_right),
      quarter * (-wheels.front_left + wheels.front_right + wheels.back_left - wheels.back_right),
      quarter * (-wheels.front_left + wheels.front_right - wheels.back_left + wheels.back_right) /
          size.arm()};
}

class MecanumOdometry {
 public:
  explicit MecanumOdometry(const MecanumSize& size) : size_(size) {}

  /// `wheels` are angles, `seconds` is what has passed.
  void update(const MecanumWheels& wheels, double seconds) {
    const MecanumWheels change{
        wheels.front_left - last_.front_left, wheels.front_right - last_.front_right,
        wheels.back_left - last_.back_left, wheels.back_right - last_.back_right};
    last_ = wheels;
    if (!began_) {
      began_ = true;
      return;
    }
    if (seconds <= 0) return;
    const PlanarMotion way = mecanum_motion(size_, change);
    const double middle = yaw_ + way.turn / 2;
    x_ += way.forward * std::cos(middle) - way.left * std::sin(middle);
    y_ += way.forward * std::sin(middle) + way.left * std::cos(middle);
    yaw_ += way.turn;
    speed = {way.forward / seconds, way.left / seconds, way.turn / seconds};
  }

  Pose pose() const { return {{x_, y_, 0}, from_roll_pitch_yaw(0, 0, yaw_)}; }
  PlanarMotion speed;

 private:
  MecanumSize size_;
  MecanumWheels last_;
  bool began_ = false;
  double x_ = 0, y_ = 0, yaw_ = 0;
};

}  // namespace ros2wasm_sim
