// Where a base with two driven sides is, by its wheels or by its commands. Knows nothing of ROS.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rcppmath/rolling_mean_accumulator.hpp"

namespace diff_drive_controller {

/// Speeds of the wheels [rad/s].
struct WheelSpeeds {
  double left = 0.0;
  double right = 0.0;
};

/// The wheels of a base, in metres.
struct WheelGeometry {
  double separation = 0.0;
  double left_radius = 0.0;
  double right_radius = 0.0;
};

/// The speeds that the wheels need for a speed [m/s] and a rate of turn [rad/s].
WheelSpeeds wheel_speeds(double linear, double angular, const WheelGeometry& geometry);

class Odometry {
 public:
  explicit Odometry(size_t velocity_rolling_window_size = 10);

  /// The next update counts from this time on.
  void init(int64_t time_ns);
  /// By the positions of the wheels [rad]. False when less than 0.1 ms have passed.
  bool update(double left_pos, double right_pos, int64_t time_ns);
  /// By the ways of the wheels since the last update [m].
  bool updateFromVelocity(double left_vel, double right_vel, int64_t time_ns);
  /// By what was commanded [m/s, rad/s].
  void updateOpenLoop(double linear, double angular, int64_t time_ns);
  void resetOdometry();

  double getX() const { return x_; }
  double getY() const { return y_; }
  double getHeading() const { return heading_; }
  double getLinear() const { return linear_; }    ///< [m/s]
  double getAngular() const { return angular_; }  ///< [rad/s]

  void setWheelParams(double wheel_separation, double left_wheel_radius, double right_wheel_radius);
  void setVelocityRollingWindowSize(size_t velocity_rolling_window_size);

 private:
  using Mean = rcppmath::RollingMeanAccumulator<double>;

  /// After simulated time was set back: begins again at that time, and keeps the pose.
  bool was_set_back(int64_t time_ns);
  double seconds_until(int64_t time_ns) const;
  void integrate(double linear, double angular);
  void reset_means();

  int64_t time_ns_ = 0;
  double x_ = 0.0;
  double y_ = 0.0;
  double heading_ = 0.0;
  double linear_ = 0.0;
  double angular_ = 0.0;
  WheelGeometry wheels_;
  double left_way_ = 0.0;   ///< of the last update [m]
  double right_way_ = 0.0;  ///< the same
  size_t window_;
  Mean linear_mean_;
  Mean angular_mean_;
};

}  // namespace diff_drive_controller
