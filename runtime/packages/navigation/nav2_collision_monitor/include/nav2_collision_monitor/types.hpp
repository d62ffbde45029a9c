// Velocities, points and actions of the collision monitor.
#pragma once

#include <string>

namespace nav2_collision_monitor {

struct Velocity {
  double x;   // m/s
  double y;   // m/s
  double tw;  // rad/s

  /// By the sum of squares, so that turning on the spot counts, too.
  bool operator<(const Velocity& second) const {
    return x * x + y * y + tw * tw <
           second.x * second.x + second.y * second.y + second.tw * second.tw;
  }
  Velocity operator*(const double& mul) const { return {x * mul, y * mul, tw * mul}; }
  bool isZero() const { return x == 0.0 && y == 0.0 && tw == 0.0; }
};

/// In metres.
struct Point {
  double x;
  double y;
};

struct Pose {
  double x;
  double y;
  double theta;
};

/// The numbers are those of nav2_msgs/CollisionMonitorState.
enum ActionType { DO_NOTHING = 0, STOP = 1, SLOWDOWN = 2, APPROACH = 3, LIMIT = 4 };

struct Action {
  ActionType action_type;
  Velocity req_vel;
  std::string polygon_name;  // empty, or what caused it
};

}  // namespace nav2_collision_monitor
