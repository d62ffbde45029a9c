// How far velocities may change from one cycle to the next, without ROS. Velocities are those along
// x and y [m/s] and about z [rad/s].
#pragma once

#include <array>

namespace nav2_velocity_smoother {

using Velocity = std::array<double, 3>;

/// One axis. The deceleration is not positive.
struct AxisLimits {
  double accel;  // m/s^2 or rad/s^2
  double decel;
};

/// The factor that shortens the change of an axis to what `frequency` [Hz] allows in one cycle; -1
/// when the change is small enough.
double find_eta(double current, double command, AxisLimits limits, double frequency);
/// The velocity one cycle later: `eta` times the change, within the limits.
double stepped(double current, double command, AxisLimits limits, double eta, double frequency);

struct Limits {
  Velocity min_velocity;
  Velocity max_velocity;
  std::array<AxisLimits, 3> axes;
  double frequency;  // Hz
  /// Whether all axes change in proportion, so that the direction is that of the command.
  bool scales;
};

/// The command within the velocities that are allowed.
Velocity clamped(const Velocity& command, const Limits& limits);
/// The velocity one cycle later on all axes.
Velocity next_velocity(const Velocity& current, const Velocity& command, const Limits& limits);

}  // namespace nav2_velocity_smoother
