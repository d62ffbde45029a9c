// The limits of a robot: velocities [m/s, rad/s] and accelerations [m/s^2, rad/s^2]. Knows nothing
// of ROS.
#pragma once

#include <cmath>
#include <limits>

namespace dwb_plugins {

struct KinematicParameters {
  friend class KinematicsHandler;

  inline double getMinX() { return min_vel_x_; }
  inline double getMaxX() { return max_vel_x_; }
  inline double getAccX() { return acc_lim_x_; }
  inline double getDecelX() { return decel_lim_x_; }

  inline double getMinY() { return min_vel_y_; }
  inline double getMaxY() { return max_vel_y_; }
  inline double getAccY() { return acc_lim_y_; }
  inline double getDecelY() { return decel_lim_y_; }

  inline double getMinSpeedXY() { return min_speed_xy_; }
  inline double getMaxSpeedXY() { return max_speed_xy_; }

  inline double getMinTheta() { return -max_vel_theta_; }
  inline double getMaxTheta() { return max_vel_theta_; }
  inline double getAccTheta() { return acc_lim_theta_; }
  inline double getDecelTheta() { return decel_lim_theta_; }
  inline double getMinSpeedTheta() { return min_speed_theta_; }

  inline double getMinSpeedXY_SQ() { return min_speed_xy_sq_; }
  inline double getMaxSpeedXY_SQ() { return max_speed_xy_sq_; }

  /// Standing still is not valid; a limit below 0 does not count.
  inline bool isValidSpeed(double x, double y, double theta) {
    constexpr double kEpsilon = std::numeric_limits<float>::epsilon();
    const double speed_sq = x * x + y * y;
    if (max_speed_xy_ >= 0.0 && speed_sq > max_speed_xy_sq_ + kEpsilon) return false;
    const bool is_slow = min_speed_xy_ >= 0.0 && speed_sq + kEpsilon < min_speed_xy_sq_;
    const bool turns_slowly =
        min_speed_theta_ >= 0.0 && std::abs(theta) + kEpsilon < min_speed_theta_;
    return !(is_slow && turns_slowly) && !(speed_sq == 0.0 && theta == 0.0);
  }

 protected:
  /// All velocities in the same proportion, so the robot drives the same curves. A limit above the
  /// greatest speed changes nothing, and 0 ends it.
  void limitSpeed(double speed_limit, bool percentage) {
    double ratio = 1.0;
    if (speed_limit != 0.0) {
      ratio = percentage ? speed_limit / 100.0 : speed_limit / base_max_speed_xy_;
      if (!percentage && !(speed_limit < base_max_speed_xy_)) return;
    }
    max_speed_xy_ = base_max_speed_xy_ * ratio;
    max_vel_x_ = base_max_vel_x_ * ratio;
    max_vel_y_ = base_max_vel_y_ * ratio;
    max_vel_theta_ = base_max_vel_theta_ * ratio;
    squareSpeeds();
  }

  void squareSpeeds() {
    min_speed_xy_sq_ = min_speed_xy_ * min_speed_xy_;
    max_speed_xy_sq_ = max_speed_xy_ * max_speed_xy_;
  }

  // Names with `base` are limits without a speed limit.
  double min_vel_x_{0};
  double min_vel_y_{0};
  double max_vel_x_{0};
  double max_vel_y_{0};
  double base_max_vel_x_{0};
  double base_max_vel_y_{0};
  double max_vel_theta_{0};
  double base_max_vel_theta_{0};
  double min_speed_xy_{0};
  double max_speed_xy_{0};
  double base_max_speed_xy_{0};
  double min_speed_theta_{0};
  double acc_lim_x_{0};
  double acc_lim_y_{0};
  double acc_lim_theta_{0};
  double decel_lim_x_{0};
  double decel_lim_y_{0};
  double decel_lim_theta_{0};
  double min_speed_xy_sq_{0};
  double max_speed_xy_sq_{0};
};

}  // namespace dwb_plugins
