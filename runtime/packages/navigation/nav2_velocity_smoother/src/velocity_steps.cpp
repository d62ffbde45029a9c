// See velocity_steps.hpp.
#include "velocity_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nav2_velocity_smoother {
namespace {

/// The largest change in one cycle. A velocity that grows away from zero accelerates; one that
/// comes nearer to zero, or passes it, decelerates.
double largest_change(double current, double command, AxisLimits limits, double frequency) {
  const bool accelerates = std::abs(command) >= std::abs(current) && current * command >= 0.0;
  return (accelerates ? limits.accel : -limits.decel) / frequency;
}

/// The factor that is furthest from 1 fits all axes.
double common_eta(const Velocity& current, const Velocity& command, const Limits& limits) {
  double eta = 1.0;
  for (size_t i = 0; i < current.size(); ++i) {
    const double one = find_eta(current[i], command[i], limits.axes[i], limits.frequency);
    if (one > 0.0 && std::abs(1.0 - one) > std::abs(1.0 - eta)) eta = one;
  }
  return eta;
}

}  // namespace

double find_eta(double current, double command, AxisLimits limits, double frequency) {
  const double change = command - current;
  const double most = largest_change(current, command, limits, frequency);
  return std::abs(change) > most ? most / std::abs(change) : -1.0;
}

double stepped(double current, double command, AxisLimits limits, double eta, double frequency) {
  const double most = largest_change(current, command, limits, frequency);
  return current + std::clamp(eta * (command - current), -most, most);
}

Velocity clamped(const Velocity& command, const Limits& limits) {
  Velocity result{};
  for (size_t i = 0; i < result.size(); ++i) {
    result[i] = std::clamp(command[i], limits.min_velocity[i], limits.max_velocity[i]);
  }
  return result;
}

Velocity next_velocity(const Velocity& current, const Velocity& command, const Limits& limits) {
  const double eta = limits.scales ? common_eta(current, command, limits) : 1.0;
  Velocity result{};
  for (size_t i = 0; i < result.size(); ++i) {
    result[i] = stepped(current[i], command[i], limits.axes[i], eta, limits.frequency);
  }
  return result;
}

}  // namespace nav2_velocity_smoother
