// Bases with steered wheels: commands of the wheels, and where the base is. Knows nothing of ROS.
#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

#include "rcppmath/rolling_mean_accumulator.hpp"

namespace steering_kinematics {

constexpr unsigned int BICYCLE_CONFIG = 0;    ///< one driven wheel, one steered
constexpr unsigned int TRICYCLE_CONFIG = 1;   ///< two driven wheels, one steered
constexpr unsigned int ACKERMANN_CONFIG = 2;  ///< two driven wheels, two steered

/// Wheels in pairs are the right one and then the left one.
class SteeringKinematics {
 public:
  explicit SteeringKinematics(size_t velocity_rolling_window_size = 10);

  /// By positions of driven wheels and of steered ones [rad], after `dt` [s]. False when less than
  /// 0.1 ms have passed: then the speed stays as it was.
  bool update_from_position(double traction_wheel_pos, double steer_pos, double dt);
  bool update_from_position(double right_wheel_pos, double left_wheel_pos, double steer_pos,
                            double dt);
  bool update_from_position(double right_wheel_pos, double left_wheel_pos, double right_steer_pos,
                            double left_steer_pos, double dt);
  /// By speeds of driven wheels [rad/s] and positions of steered ones.
  bool update_from_velocity(double traction_wheel_vel, double steer_pos, double dt);
  bool update_from_velocity(double right_wheel_vel, double left_wheel_vel, double steer_pos,
                            double dt);
  bool update_from_velocity(double right_wheel_vel, double left_wheel_vel, double right_steer_pos,
                            double left_steer_pos, double dt);
  /// By what was commanded [m/s, rad/s].
  void update_open_loop(double v_bx, double omega_bz, double dt);

  void set_odometry_type(unsigned int type) { type_ = type; }
  unsigned int get_odometry_type() const { return type_; }
  double get_heading() const { return heading_; }
  double get_x() const { return x_; }
  double get_y() const { return y_; }
  double get_linear() const { return linear_; }    ///< [m/s]
  double get_angular() const { return angular_; }  ///< [rad/s]

  /// All in metres.
  void set_wheel_params(double wheel_radius, double wheel_base, double wheel_track = 0.0);
  void set_wheel_params(double wheel_radius, double wheel_base, double wheel_track_steering,
                        double wheel_track_traction);
  void set_velocity_rolling_window_size(size_t velocity_rolling_window_size);

  /// Speeds of the driven wheels [rad/s], and angles of the steered ones [rad].
  std::tuple<std::vector<double>, std::vector<double>> get_commands(
      double v_bx, double omega_bz, bool open_loop = true,
      bool reduce_wheel_speed_until_steering_reached = false) const;
  void reset_odometry();

 private:
  using Mean = rcppmath::RollingMeanAccumulator<double>;

  bool update(double linear, double dt);
  double speed_of_axle(double right_wheel_vel, double left_wheel_vel) const;
  void integrate(double linear, double angular, double dt);
  void reset_means();

  unsigned int type_ = BICYCLE_CONFIG;
  double x_ = 0.0;
  double y_ = 0.0;
  double heading_ = 0.0;
  double linear_ = 0.0;
  double angular_ = 0.0;
  double steer_pos_ = 0.0;  ///< measured, of the middle of the steered axle
  double radius_ = 0.0;
  double base_ = 0.0;
  double steering_track_ = 0.0;
  double traction_track_ = 0.0;
  double right_pos_ = 0.0;  ///< of the last update, also of a single wheel
  double left_pos_ = 0.0;
  size_t window_;
  Mean linear_mean_;
  Mean angular_mean_;
};

}  // namespace steering_kinematics
