// See regulated_pure_pursuit_controller.hpp.
#include "nav2_regulated_pure_pursuit_controller/regulated_pure_pursuit_controller.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "angles/angles.h"
#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_costmap_2d/costmap_filters/filter_values.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "pursuit_math.hpp"
#include "tf2/utils.h"

namespace nav2_regulated_pure_pursuit_controller {

using geometry_msgs::msg::Point;
using geometry_msgs::msg::PointStamped;
using geometry_msgs::msg::TwistStamped;
using nav2_util::geometry_utils::calculate_path_length;

namespace {

constexpr const char* kType = "regulated_pure_pursuit_controller::RegulatedPurePursuitController";

PursuitPoint flat(const Point& point) {
  return {point.x, point.y};
}

Point point_of(PursuitPoint flat_point) {
  Point point;
  point.x = flat_point.x;
  point.y = flat_point.y;
  return point;
}

double distance_of(const Point& point) {
  return std::hypot(point.x, point.y);
}

}  // namespace

void RegulatedPurePursuitController::configure(
    const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name,
    std::shared_ptr<tf2_ros::Buffer> tf,
    std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) {
  const auto node = parent.lock();
  if (!node) throw nav2_core::ControllerException("Unable to lock node!");
  node_ = parent;
  plugin_name_ = std::move(name);
  tf_ = std::move(tf);
  costmap_ros_ = std::move(costmap_ros);
  costmap_ = costmap_ros_->getCostmap();
  logger_ = node->get_logger();
  readParameters();
  checker_ =
      std::make_unique<nav2_costmap_2d::FootprintCollisionChecker<nav2_costmap_2d::Costmap2D*>>(
          costmap_);
  double frequency = 20.0;
  node->get_parameter("controller_frequency", frequency);
  control_duration_ = 1.0 / frequency;
  global_path_pub_ = node->create_publisher<Path>("received_global_plan", 1);
  carrot_pub_ = node->create_publisher<PointStamped>("lookahead_point", 1);
  curvature_carrot_pub_ = node->create_publisher<PointStamped>("curvature_lookahead_point", 1);
  is_rotating_to_heading_pub_ =
      node->create_publisher<std_msgs::msg::Bool>("is_rotating_to_heading", 1);
  carrot_arc_pub_ = node->create_publisher<Path>("lookahead_collision_arc", 1);
}

void RegulatedPurePursuitController::cleanup() {
  RCLCPP_INFO(logger_, "Cleaning up controller: %s of type %s", plugin_name_.c_str(), kType);
  global_path_pub_.reset();
  carrot_pub_.reset();
  curvature_carrot_pub_.reset();
  is_rotating_to_heading_pub_.reset();
  carrot_arc_pub_.reset();
  dyn_params_handler_.reset();
}

void RegulatedPurePursuitController::activate() {
  RCLCPP_INFO(logger_, "Activating controller: %s of type %s", plugin_name_.c_str(), kType);
  global_path_pub_->on_activate();
  carrot_pub_->on_activate();
  curvature_carrot_pub_->on_activate();
  is_rotating_to_heading_pub_->on_activate();
  carrot_arc_pub_->on_activate();
}

void RegulatedPurePursuitController::deactivate() {
  RCLCPP_INFO(logger_, "Deactivating controller: %s of type %s", plugin_name_.c_str(), kType);
  global_path_pub_->on_deactivate();
  carrot_pub_->on_deactivate();
  curvature_carrot_pub_->on_deactivate();
  is_rotating_to_heading_pub_->on_deactivate();
  carrot_arc_pub_->on_deactivate();
}

void RegulatedPurePursuitController::setPlan(const Path& path) {
  has_reached_xy_tolerance_ = false;
  global_plan_ = path;
}

void RegulatedPurePursuitController::reset() {
  cancelling_ = false;
  finished_cancelling_ = false;
  has_reached_xy_tolerance_ = false;
}

bool RegulatedPurePursuitController::cancel() {
  if (!params_.use_cancel_deceleration) return true;
  cancelling_ = true;
  return finished_cancelling_;
}

void RegulatedPurePursuitController::setSpeedLimit(const double& speed_limit,
                                                   const bool& percentage) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (speed_limit == nav2_costmap_2d::NO_SPEED_LIMIT) {
    params_.desired_linear_vel = params_.base_desired_linear_vel;
  } else {
    params_.desired_linear_vel =
        percentage ? params_.base_desired_linear_vel * speed_limit / 100.0 : speed_limit;
  }
}

TwistStamped RegulatedPurePursuitController::computeVelocityCommands(
    const PoseStamped& pose, const geometry_msgs::msg::Twist& velocity,
    nav2_core::GoalChecker* goal_checker) {
  const std::lock_guard<std::mutex> parameters(mutex_);
  const std::unique_lock<nav2_costmap_2d::Costmap2D::mutex_t> cells(*costmap_->getMutex());
  geometry_msgs::msg::Pose pose_tolerance;
  geometry_msgs::msg::Twist vel_tolerance;
  if (goal_checker->getTolerances(pose_tolerance, vel_tolerance)) {
    goal_dist_tol_ = pose_tolerance.position.x;
  } else {
    RCLCPP_WARN(logger_, "Unable to retrieve goal checker's tolerances!");
  }

  const Path path = planAhead(pose);
  global_path_pub_->publish(path);
  double distance = lookAheadDistance(velocity.linear.x);
  double curvature_distance = params_.curvature_lookahead_dist;
  if (params_.allow_reversing) {
    const double cusp = distanceToCusp(path);
    distance = std::min(distance, cusp);
    curvature_distance = std::min(curvature_distance, cusp);
  }
  const Point carrot = pointAhead(distance, path);
  showPoint(carrot_pub_, carrot, path.header);
  Point curvature_carrot = carrot;
  if (params_.use_fixed_curvature_lookahead) {
    curvature_carrot =
        pointAhead(curvature_distance, path, params_.interpolate_curvature_after_goal);
    showPoint(curvature_carrot_pub_, curvature_carrot, path.header);
  }

  const Speeds speeds = speedsFor(pose, velocity, path, carrot, curvature_carrot);
  if (params_.use_collision_detection && isCollisionImminent(pose, speeds, distance_of(carrot))) {
    throw nav2_core::NoValidControl("RegulatedPurePursuitController detected collision ahead!");
  }
  std_msgs::msg::Bool is_rotating;
  is_rotating.data = is_rotating_to_heading_;
  is_rotating_to_heading_pub_->publish(is_rotating);
  TwistStamped command;
  command.header = pose.header;
  command.twist.linear.x = speeds.linear;
  command.twist.angular.z = speeds.angular;
  return command;
}

RegulatedPurePursuitController::Speeds RegulatedPurePursuitController::speedsFor(
    const PoseStamped& pose, const geometry_msgs::msg::Twist& velocity, const Path& path,
    const Point& carrot, const Point& curvature_carrot) {
  const double direction = params_.allow_reversing && carrot.x < 0.0 ? -1.0 : 1.0;
  const auto turn = [&](double angle) {
    is_rotating_to_heading_ = true;
    return Speeds{0.0,
                  speed_of_turn(angle, velocity.angular.z, params_.rotate_to_heading_angular_vel,
                                params_.max_angular_accel, control_duration_)};
  };
  if (turnsToGoal(carrot)) return turn(tf2::getYaw(path.poses.back().pose.orientation));
  double angle = std::atan2(curvature_carrot.y, curvature_carrot.x);
  if (direction < 0) angle = angles::normalize_angle(angle + M_PI);
  if (params_.use_rotate_to_heading && std::abs(angle) > params_.rotate_to_heading_min_angle) {
    return turn(angle);
  }
  is_rotating_to_heading_ = false;
  const double curvature = curvature_to(flat(curvature_carrot));
  double speed = direction * drivingSpeed(pose, path, curvature);
  if (cancelling_) speed = brakingSpeed(velocity.linear.x, direction);
  return {speed, speed * curvature};
}

bool RegulatedPurePursuitController::turnsToGoal(const Point& carrot) {
  if (!params_.use_rotate_to_heading) return false;
  const bool is_near = distance_of(carrot) < goal_dist_tol_;
  if (!params_.stateful) return is_near;
  has_reached_xy_tolerance_ = has_reached_xy_tolerance_ || is_near;
  return has_reached_xy_tolerance_;
}

double RegulatedPurePursuitController::drivingSpeed(const PoseStamped& pose, const Path& path,
                                                    double curvature) const {
  double speed = params_.desired_linear_vel;
  if (params_.use_regulated_linear_velocity_scaling) {
    speed = speed_on_arc(speed, curvature, params_.regulated_linear_scaling_min_radius);
  }
  if (params_.use_cost_regulated_linear_velocity_scaling) {
    const CostRule rule{costmap_ros_->getLayeredCostmap()->getInscribedRadius(),
                        params_.inflation_cost_scaling_factor, params_.cost_scaling_dist,
                        params_.cost_scaling_gain};
    const double cost = costAt(pose.pose.position.x, pose.pose.position.y);
    speed = std::min(speed, speed_near_obstacles(params_.desired_linear_vel, cost, rule));
  }
  speed = std::max(speed, params_.regulated_linear_scaling_min_speed);
  speed = speed_of_approach(
      speed, calculate_path_length(path), distance_of(path.poses.back().pose.position),
      params_.approach_velocity_scaling_dist, params_.min_approach_linear_velocity);
  return std::clamp(std::abs(speed), 0.0, std::max(0.0, params_.desired_linear_vel));
}

double RegulatedPurePursuitController::brakingSpeed(double speed, double direction) {
  const double slower = speed - direction * control_duration_ * params_.cancel_deceleration;
  if (slower * direction > 0) return slower;
  finished_cancelling_ = true;
  return 0.0;
}

double RegulatedPurePursuitController::lookAheadDistance(double speed) const {
  if (!params_.use_velocity_scaled_lookahead_dist) return params_.lookahead_dist;
  return std::clamp(std::abs(speed) * params_.lookahead_time, params_.min_lookahead_dist,
                    std::max(params_.min_lookahead_dist, params_.max_lookahead_dist));
}

Point RegulatedPurePursuitController::pointAhead(double distance, const Path& path,
                                                 bool goes_beyond_end) const {
  const auto& poses = path.poses;
  const auto beyond = std::find_if(poses.begin(), poses.end(), [&](const PoseStamped& one) {
    return distance_of(one.pose.position) >= distance;
  });
  if (beyond == poses.begin()) return beyond->pose.position;
  if (beyond != poses.end()) {
    const Point& inner = std::prev(beyond)->pose.position;
    return point_of(crossing(flat(inner), flat(beyond->pose.position), distance));
  }
  const Point& last = poses.back().pose.position;
  if (!goes_beyond_end || poses.size() < 2) return last;
  // On, in the direction of the last two poses.
  const Point& before = poses[poses.size() - 2].pose.position;
  const double heading = std::atan2(last.y - before.y, last.x - before.x);
  const PursuitPoint outer{last.x + 2 * distance * std::cos(heading),
                           last.y + 2 * distance * std::sin(heading)};
  return point_of(crossing(flat(last), outer, distance));
}

double RegulatedPurePursuitController::distanceToCusp(const Path& path) const {
  for (size_t i = 1; i + 1 < path.poses.size(); ++i) {
    const auto& before = path.poses[i - 1].pose;
    const auto& here = path.poses[i].pose;
    const auto& after = path.poses[i + 1].pose;
    const double ax = here.position.x - before.position.x;
    const double ay = here.position.y - before.position.y;
    const double bx = after.position.x - here.position.x;
    const double by = after.position.y - here.position.y;
    const bool turns_back = ax * bx + ay * by < 0.0;
    const bool turns_here = (ax == 0 && ay == 0 && before.orientation != here.orientation) ||
                            (bx == 0 && by == 0 && here.orientation != after.orientation);
    if (turns_back || turns_here) return distance_of(here.position);
  }
  return std::numeric_limits<double>::max();
}

bool RegulatedPurePursuitController::isCollisionImminent(const PoseStamped& pose,
                                                         const Speeds& speeds,
                                                         double carrot_distance) {
  const Point& robot = pose.pose.position;
  geometry_msgs::msg::Pose2D next;
  next.x = robot.x;
  next.y = robot.y;
  next.theta = tf2::getYaw(pose.pose.orientation);
  if (isInCollision(next.x, next.y, next.theta)) return true;
  // The time in which the robot, or its farthest corner, moves by a cell.
  double step = costmap_->getResolution() / std::abs(speeds.linear);
  if (std::abs(speeds.linear) < 0.01 && std::abs(speeds.angular) > 0.01) {
    const double radius = costmap_ros_->getLayeredCostmap()->getCircumscribedRadius();
    step = 2.0 * std::asin(std::min(1.0, costmap_->getResolution() / 2 / radius)) /
           std::abs(speeds.angular);
  }
  // The robot stands, or has no size that counts.
  if (!(step > 0.0) || !std::isfinite(step)) return false;
  Path arc;
  arc.header.frame_id = costmap_ros_->getGlobalFrameID();
  arc.header.stamp = pose.header.stamp;
  bool collides = false;
  for (double time = step; !collides && time < params_.max_allowed_time_to_collision_up_to_carrot;
       time += step) {
    next.x += step * speeds.linear * std::cos(next.theta);
    next.y += step * speeds.linear * std::sin(next.theta);
    next.theta += step * speeds.angular;
    // Beyond the carrot the command is another one.
    if (std::hypot(next.x - robot.x, next.y - robot.y) > carrot_distance) break;
    PoseStamped shown;
    shown.header = arc.header;
    shown.pose.position.x = next.x;
    shown.pose.position.y = next.y;
    shown.pose.position.z = 0.01;
    arc.poses.push_back(shown);
    collides = isInCollision(next.x, next.y, next.theta);
  }
  carrot_arc_pub_->publish(arc);
  return collides;
}

bool RegulatedPurePursuitController::isInCollision(double x, double y, double theta) {
  unsigned int mx;
  unsigned int my;
  if (!costmap_->worldToMap(x, y, mx, my)) {
    RCLCPP_WARN_THROTTLE(logger_, *node_.lock()->get_clock(), 30000,
                         "The dimensions of the costmap is too small to successfully check for "
                         "collisions as far ahead as requested. Proceed at your own risk, slow the "
                         "robot, or increase your costmap size.");
    return false;
  }
  const double cost = checker_->footprintCostAtPose(x, y, theta, costmap_ros_->getRobotFootprint());
  if (cost == nav2_costmap_2d::NO_INFORMATION &&
      costmap_ros_->getLayeredCostmap()->isTrackingUnknown()) {
    return false;
  }
  return cost >= nav2_costmap_2d::LETHAL_OBSTACLE;
}

double RegulatedPurePursuitController::costAt(double x, double y) const {
  unsigned int mx;
  unsigned int my;
  if (!costmap_->worldToMap(x, y, mx, my)) {
    RCLCPP_FATAL(logger_,
                 "The dimensions of the costmap is too small to fully include your robot's "
                 "footprint, thusly the robot cannot proceed further");
    throw nav2_core::ControllerException(
        "RegulatedPurePursuitController: Dimensions of the costmap are too small to encapsulate "
        "the robot footprint at current speeds!");
  }
  return costmap_->getCost(mx, my);
}

void RegulatedPurePursuitController::showPoint(const Publisher<PointStamped>& publisher,
                                               const Point& point,
                                               const std_msgs::msg::Header& header) const {
  PointStamped message;
  message.header = header;
  message.point = point;
  message.point.z = 0.01;  // above the map
  publisher->publish(message);
}

}  // namespace nav2_regulated_pure_pursuit_controller

PLUGINLIB_EXPORT_CLASS(nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController,
                       nav2_core::Controller)
