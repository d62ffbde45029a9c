// See pursuit_math.hpp.
#include "pursuit_math.hpp"

#include <algorithm>
#include <cmath>

namespace nav2_regulated_pure_pursuit_controller {
namespace {

/// Square of the distance [m] below which a point is at the robot.
constexpr double kHere = 0.001;
/// Costs of cells: of the inscribed radius, and unknown.
constexpr double kInscribed = 253.0;
constexpr double kUnknown = 255.0;

}  // namespace

double curvature_to(PursuitPoint point) {
  const double square = point.x * point.x + point.y * point.y;
  return square > kHere ? 2.0 * point.y / square : 0.0;
}

PursuitPoint crossing(PursuitPoint inner, PursuitPoint outer, double radius) {
  const double dx = outer.x - inner.x;
  const double dy = outer.y - inner.y;
  const double a = dx * dx + dy * dy;
  if (!(a > 0)) return inner;
  // |inner + t d| = radius, for the t that is not negative.
  const double b = inner.x * dx + inner.y * dy;
  const double c = inner.x * inner.x + inner.y * inner.y - radius * radius;
  const double t = (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
  return {inner.x + t * dx, inner.y + t * dy};
}

double speed_on_arc(double speed, double curvature, double min_radius) {
  if (curvature == 0.0) return speed;
  const double radius = std::abs(1.0 / curvature);
  return radius < min_radius ? speed * radius / min_radius : speed;
}

double speed_near_obstacles(double speed, double cost, const CostRule& rule) {
  if (!(cost > 0) || cost == kUnknown) return speed;
  const double distance =
      rule.inscribed_radius + (std::log(kInscribed) - std::log(cost)) / rule.scaling_factor;
  return distance < rule.distance ? speed * rule.gain * distance / rule.distance : speed;
}

double speed_of_approach(double speed, double left, double end, double begin_at, double least) {
  const double share = left < begin_at ? end / begin_at : 1.0;
  return std::min(speed, std::max(speed * share, least));
}

double speed_of_turn(double angle, double present, double fastest, double acceleration, double dt) {
  const double sign = angle > 0.0 ? 1.0 : -1.0;
  const double reached =
      std::clamp(sign * fastest, present - acceleration * dt, present + acceleration * dt);
  const double can_stop = std::sqrt(2 * acceleration * std::abs(angle));
  return std::abs(reached) > can_stop ? sign * can_stop : reached;
}

}  // namespace nav2_regulated_pure_pursuit_controller
