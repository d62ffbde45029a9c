// See zone_math.hpp.
#include "zone_math.hpp"

#include <algorithm>
#include <cmath>

#include "nav2_collision_monitor/kinematics.hpp"

namespace nav2_collision_monitor {
namespace {

// Bounds what one message can cost: an outline that is longer has its points further apart.
constexpr double kMostPieces = 100'000;

bool is_direction_in_range(double direction, const SpeedRange& range) {
  const bool is_after = direction >= range.direction_start;
  const bool is_before = direction <= range.direction_end;
  // A range may pass through pi.
  return range.direction_start <= range.direction_end ? is_after && is_before
                                                      : is_after || is_before;
}

}  // namespace

// Counts the edges that a ray along x crosses; an odd number is inside. An edge has its lower end
// and lacks its upper one, so a ray through a vertex crosses once.
bool is_inside(const std::vector<Point>& polygon, const Point& point) {
  if (polygon.empty()) return false;
  bool inside = false;
  Point from = polygon.back();
  for (const Point& to : polygon) {
    if ((point.y <= from.y) == (point.y > to.y)) {
      const double crossing = from.x + (point.y - from.y) * (to.x - from.x) / (to.y - from.y);
      if (crossing > point.x) inside = !inside;
    }
    from = to;
  }
  return inside;
}

int count_inside(const std::vector<Point>& polygon, const std::vector<Point>& points) {
  return static_cast<int>(
      std::count_if(points.begin(), points.end(),
                    [&polygon](const Point& point) { return is_inside(polygon, point); }));
}

double time_to_collision(const std::vector<Point>& obstacles, Velocity velocity,
                         const Forecast& forecast,
                         const std::function<int(const std::vector<Point>&)>& count_in_zone) {
  if (count_in_zone(obstacles) >= forecast.min_points) return 0.0;
  Pose pose{0.0, 0.0, 0.0};
  std::vector<Point> seen;
  for (double time = 0.0; time <= forecast.horizon; time += forecast.step) {
    projectState(forecast.step, pose, velocity);
    seen = obstacles;
    transformPoints(pose, seen);
    if (count_in_zone(seen) >= forecast.min_points) return time;
  }
  return -1.0;
}

double limit_ratio(const Velocity& velocity, double linear_limit, double angular_limit) {
  double ratio = 1.0;
  const double speed = std::hypot(velocity.x, velocity.y);
  if (speed != 0.0) ratio = std::min(ratio, linear_limit / speed);
  if (velocity.tw != 0.0) ratio = std::min(ratio, angular_limit / std::abs(velocity.tw));
  return std::max(ratio, 0.0);
}

bool is_in_range(const Velocity& velocity, const SpeedRange& range, bool holonomic) {
  if (velocity.tw < range.theta_min || velocity.tw > range.theta_max) return false;
  if (!holonomic) return velocity.x >= range.linear_min && velocity.x <= range.linear_max;
  const double speed = std::hypot(velocity.x, velocity.y);
  const double direction = speed > 0.0 ? std::atan2(velocity.y, velocity.x) : 0.0;
  return speed >= range.linear_min && speed <= range.linear_max &&
         is_direction_in_range(direction, range);
}

std::vector<Point> arc_points(double distance, double field_of_view, double step) {
  std::vector<Point> points;
  const double end = field_of_view / 2;
  for (double angle = -end; angle < end; angle += step) {
    points.push_back({distance * std::cos(angle), distance * std::sin(angle)});
  }
  points.push_back({distance * std::cos(end), distance * std::sin(end)});
  return points;
}

std::vector<Point> outline_points(const std::vector<Point>& polygon, double distance) {
  const auto next = [&polygon](size_t i) { return polygon[(i + 1) % polygon.size()]; };
  const auto length = [](const Point& from, const Point& to) {
    return std::hypot(to.x - from.x, to.y - from.y);
  };
  double perimeter = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i) perimeter += length(polygon[i], next(i));
  distance = std::max(distance, perimeter / kMostPieces);
  std::vector<Point> points;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Point& from = polygon[i];
    const Point to = next(i);
    const double pieces = std::ceil(length(from, to) / distance);
    const int count = static_cast<int>(std::clamp(pieces, 1.0, kMostPieces));
    const double dx = (to.x - from.x) / count;
    const double dy = (to.y - from.y) / count;
    for (int j = 0; j <= count; ++j) points.push_back({from.x + j * dx, from.y + j * dy});
  }
  return points;
}

}  // namespace nav2_collision_monitor
