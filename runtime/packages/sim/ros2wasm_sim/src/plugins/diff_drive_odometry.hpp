// Where two wheels have rolled to: exact arcs, and the mean velocity of ten steps.
#pragma once

#include <cmath>
#include <cstddef>
#include <deque>

#include "world/geometry.hpp"

namespace ros2wasm_sim {

class DiffDriveOdometry {
 public:
  /// Metres.
  DiffDriveOdometry(double separation, double radius) : separation_(separation), radius_(radius) {}

  /// `left` and `right` are the angles of the wheels (rad), `seconds` what has passed.
  void update(double left, double right, double seconds) {
    const double left_way = (left - left_) * radius_, right_way = (right - right_) * radius_;
    left_ = left;
    right_ = right;
    if (!began_) {
      began_ = true;
      return;
    }
    if (seconds <= 0) return;
    const double forward = (left_way + right_way) / 2,
                 turned = (right_way - left_way) / separation_;
    if (std::abs(turned) < 1e-6) {
      const double middle = yaw + turned / 2;
      x += forward * std::cos(middle);
      y += forward * std::sin(middle);
    } else {
      const double ratio = forward / turned;
      x += ratio * (std::sin(yaw + turned) - std::sin(yaw));
      y -= ratio * (std::cos(yaw + turned) - std::cos(yaw));
    }
    yaw += turned;
    speeds_.push_back({forward / seconds, turned / seconds, 0});
    if (speeds_.size() > kWindow) speeds_.pop_front();
  }

  double forward_speed() const { return mean().x; }
  double turn_speed() const { return mean().y; }
  Pose pose() const { return {{x, y, 0}, from_roll_pitch_yaw(0, 0, yaw)}; }

 private:
  static constexpr std::size_t kWindow = 10;

  Vector3 mean() const {
    Vector3 sum;
    for (const Vector3& one : speeds_) sum = sum + one;
    return speeds_.empty() ? sum : 1.0 / static_cast<double>(speeds_.size()) * sum;
  }

  double separation_, radius_;
  double left_ = 0, right_ = 0;
  bool began_ = false;
  double x = 0, y = 0, yaw = 0;
  std::deque<Vector3> speeds_;  ///< forward, turning
};

}  // namespace ros2wasm_sim
