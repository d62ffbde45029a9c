// How the wheels of a car turn and steer, and where it has rolled to.
#pragma once

#include <cmath>

#include "world/geometry.hpp"

namespace ros2wasm_sim {

/// Metres and radians.
struct CarSize {
  double wheel_separation = 1;  ///< of the driven wheels
  double kingpin_width = 0.8;   ///< between the axes that the front wheels steer about
  double wheel_base = 1;        ///< between the axles
  double wheel_radius = 0.2;
  double steering_limit = 0.5;
};

struct SteeringAngles {
  double left = 0, right = 0;
};

/// The angles of the two front wheels when the middle of the rear axle goes round a circle of this
/// radius, which is positive to the left.
inline SteeringAngles steering_at(const CarSize& car, double radius) {
  return {std::atan(car.wheel_base / (radius - car.kingpin_width / 2)),
          std::atan(car.wheel_base / (radius + car.kingpin_width / 2))};
}

struct CarCommand {
  SteeringAngles steering;
  double left_speed = 0, right_speed = 0;  ///< of the driven wheels, rad/s
};

/// As Gazebo Sim has it, of a velocity (m/s) and a yaw rate (rad/s).
inline CarCommand car_command(const CarSize& car, double forward, double turn) {
  constexpr double kStraight = 1e9;
  const double tightest = car.wheel_base / std::sin(car.steering_limit);
  double radius = std::abs(turn) < 0.001 ? kStraight : forward / turn;
  if (radius >= 0 && radius < tightest) radius = tightest;
  if (radius < 0 && radius > -tightest) radius = -tightest;
  const double share = car.wheel_separation / (2 * radius);  // a simple differential
  return {steering_at(car, radius), forward * (1 - share) / car.wheel_radius,
          forward * (1 + share) / car.wheel_radius};
}

/// As Gazebo Classic has it: a single wheel in the middle steers by `angle`.
inline SteeringAngles steering_of_middle(double angle, double separation, double wheel_base) {
  const double tangent = std::tan(angle), share = separation / (2 * wheel_base) * tangent;
  return {std::atan2(tangent, 1 - share), std::atan2(tangent, 1 + share)};
}

class CarOdometry {
 public:
  explicit CarOdometry(const CarSize& car) : car_(car) {}

  /// Angles of the driven wheels and the steering angles, in radians; `seconds` is what has passed.
  void update(double left, double right, const SteeringAngles& steering, double seconds) {
    const double way = (left - left_ + right - right_) / 2 * car_.wheel_radius;
    left_ = left;
    right_ = right;
    if (!began_) {
      began_ = true;
      return;
    }
    if (seconds <= 0) return;
    const double turned = way * std::tan((steering.left + steering.right) / 2) / car_.wheel_base;
    yaw_ += turned;
    x_ += way * std::cos(yaw_);
    y_ += way * std::sin(yaw_);
    forward_speed = way / seconds;
    turn_speed = turned / seconds;
  }

  Pose pose() const { return {{x_, y_, 0}, from_roll_pitch_yaw(0, 0, yaw_)}; }
  double forward_speed = 0, turn_speed = 0;  ///< m/s and rad/s

 private:
  CarSize car_;
  double left_ = 0, right_ = 0;
  bool began_ = false;
  double x_ = 0, y_ = 0, yaw_ = 0;
};

}  // namespace ros2wasm_sim
