// See kinematics.hpp.
#include "nav2_collision_monitor/kinematics.hpp"

#include <cmath>

namespace nav2_collision_monitor {

void transformPoints(const Pose& pose, std::vector<Point>& points) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  for (Point& point : points) {
    const double dx = point.x - pose.x;
    const double dy = point.y - pose.y;
    point = {dx * c + dy * s, dy * c - dx * s};
  }
}

void projectState(const double& dt, Pose& pose, Velocity& velocity) {
  pose.x += velocity.x * dt;
  pose.y += velocity.y * dt;
  const double turn = velocity.tw * dt;
  pose.theta += turn;
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  velocity = {velocity.x * c - velocity.y * s, velocity.x * s + velocity.y * c, velocity.tw};
}

}  // namespace nav2_collision_monitor
