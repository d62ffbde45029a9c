// The formulas of regulated pure pursuit, without ROS. Points are in the frame of the robot: x
// ahead, y to the left, in metres.
#pragma once

namespace nav2_regulated_pure_pursuit_controller {

struct PursuitPoint {
  double x;
  double y;
};

/// The curvature of the arc from the robot to a point [1/m]; 0 for a point at the robot.
double curvature_to(PursuitPoint point);
/// Where the segment from a point within a circle around the robot to one outside of it crosses the
/// circle. The inner point when the two are one.
PursuitPoint crossing(PursuitPoint inner, PursuitPoint outer, double radius);
/// Slower on arcs that are tighter than `min_radius`.
double speed_on_arc(double speed, double curvature, double min_radius);

struct CostRule {
  double inscribed_radius;  // m
  double scaling_factor;    // of the inflation, 1/m
  double distance;          // m; farther obstacles do not count
  double gain;
};
/// Slower near obstacles: `cost` is that of an inflated costmap, from which the distance follows.
double speed_near_obstacles(double speed, double cost, const CostRule& rule);

/// Slower as the last pose comes near, but not below `least`. `left` is the length of the rest of
/// the path, `end` the distance of its last pose.
double speed_of_approach(double speed, double left, double end, double begin_at, double least);
/// The speed [rad/s] to turn by an angle [rad]: as fast as `fastest`, reached from the present
/// speed by an acceleration over `dt` [s], and such that the robot can stop in time.
double speed_of_turn(double angle, double present, double fastest, double acceleration, double dt);

}  // namespace nav2_regulated_pure_pursuit_controller
