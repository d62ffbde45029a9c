// The work of the collision monitor: from a velocity and obstacles to the velocity that is safe.
#include <utility>

#include "nav2_collision_monitor/collision_monitor_node.hpp"
#include "nav2_util/robot_utils.hpp"
#include "zone_math.hpp"

namespace nav2_collision_monitor {
namespace {

const Velocity kStandstill{0.0, 0.0, 0.0};
constexpr char kInvalidSource[] = "invalid source";

/// True when the velocity is below that of the action, which it then replaces.
bool slow_down(Action& action, const Polygon& polygon, const Velocity& velocity) {
  if (!(velocity < action.req_vel)) return false;
  action = {polygon.getActionType(), velocity, polygon.getName()};
  return true;
}

}  // namespace

void CollisionMonitor::cmdVelInCallbackStamped(geometry_msgs::msg::TwistStamped::SharedPtr msg) {
  if (!nav2_util::validateTwist(*msg)) {
    RCLCPP_ERROR(get_logger(), "Velocity message contains NaNs or Infs! Ignoring as invalid!");
    return;
  }
  process({msg->twist.linear.x, msg->twist.linear.y, msg->twist.angular.z}, msg->header);
}

void CollisionMonitor::cmdVelInCallbackUnstamped(geometry_msgs::msg::Twist::SharedPtr msg) {
  auto stamped = std::make_shared<geometry_msgs::msg::TwistStamped>();
  stamped->twist = *msg;
  cmdVelInCallbackStamped(stamped);
}

void CollisionMonitor::process(const Velocity& cmd_vel_in, const std_msgs::msg::Header& header) {
  if (!process_active_) return;
  SourcePoints points;
  Action action{DO_NOTHING, cmd_vel_in, ""};
  std::shared_ptr<Polygon> cause;
  const Source* invalid = collectPoints(points);
  if (invalid != nullptr) {
    action = {STOP, kStandstill, kInvalidSource};
    if (invalid != invalid_source_) {
      RCLCPP_WARN(get_logger(), "Source %s is invalid", invalid->getSourceName().c_str());
    }
  }
  invalid_source_ = invalid;
  publishPoints(points);
  if (enabled_) {
    cause = processPolygons(points, cmd_vel_in, action);
    if (action.polygon_name != robot_action_prev_.polygon_name) notifyActionState(action, cause);
  }
  publishVelocity(action, header);
  zones_.publish();
  robot_action_prev_ = action;
}

const Source* CollisionMonitor::collectPoints(SourcePoints& points) {
  const rclcpp::Time time = now();
  for (const auto& source : zones_.sources) {
    std::vector<Point>& of_source = points[source->getSourceName()];
    if (source->getEnabled() && !readPoints(*source, time, of_source) &&
        source->getSourceTimeout().nanoseconds() != 0) {
      return source.get();
    }
  }
  return nullptr;
}

void CollisionMonitor::publishPoints(const SourcePoints& points) {
  if (collision_points_marker_pub_->get_subscription_count() == 0) return;
  auto markers = std::make_unique<MarkerArray>();
  for (const auto& source : zones_.sources) {
    const auto found = points.find(source->getSourceName());
    if (found == points.end()) continue;
    markers->markers.push_back(
        pointsMarker(zones_.base_frame_id, "collision_points_" + found->first, found->second));
  }
  collision_points_marker_pub_->publish(std::move(markers));
}

std::shared_ptr<Polygon> CollisionMonitor::processPolygons(const SourcePoints& points,
                                                           const Velocity& velocity,
                                                           Action& action) const {
  std::shared_ptr<Polygon> cause;
  for (const auto& polygon : zones_.polygons) {
    if (action.action_type == STOP) break;
    if (!polygon->getEnabled()) continue;
    polygon->updatePolygon(velocity);
    const bool is_approach = polygon->getActionType() == APPROACH;
    if (is_approach ? processApproach(polygon, points, velocity, action)
                    : processStopSlowdownLimit(polygon, points, velocity, action)) {
      cause = polygon;
    }
  }
  return cause;
}

bool CollisionMonitor::processStopSlowdownLimit(const std::shared_ptr<Polygon> polygon,
                                                const SourcePoints& sources_collision_points_map,
                                                const Velocity& velocity,
                                                Action& robot_action) const {
  const ActionType type = polygon->getActionType();
  if (type == DO_NOTHING || !polygon->isShapeSet() ||
      polygon->getPointsInside(sources_collision_points_map) < polygon->getMinPoints()) {
    return false;
  }
  if (type == STOP) {
    robot_action = {STOP, kStandstill, polygon->getName()};
    return true;
  }
  const double ratio = type == SLOWDOWN ? polygon->getSlowdownRatio()
                                        : limit_ratio(velocity, polygon->getLinearLimit(),
                                                      polygon->getAngularLimit());
  return slow_down(robot_action, *polygon, velocity * ratio);
}

bool CollisionMonitor::processApproach(const std::shared_ptr<Polygon> polygon,
                                       const SourcePoints& sources_collision_points_map,
                                       const Velocity& velocity, Action& robot_action) const {
  if (!polygon->isShapeSet()) return false;
  const double time = polygon->getCollisionTime(sources_collision_points_map, velocity);
  if (time < 0.0) return false;
  const double horizon = polygon->getTimeBeforeCollision();
  return slow_down(robot_action, *polygon, velocity * (horizon > 0.0 ? time / horizon : 0.0));
}

void CollisionMonitor::notifyActionState(const Action& robot_action,
                                         const std::shared_ptr<Polygon> action_polygon) const {
  logAction(robot_action, action_polygon.get());
  if (!state_pub_) return;
  auto state = std::make_unique<State>();
  state->polygon_name = robot_action.polygon_name;
  state->action_type = static_cast<uint8_t>(robot_action.action_type);
  state_pub_->publish(std::move(state));
}

void CollisionMonitor::logAction(const Action& action, const Polygon* cause) const {
  const rclcpp::Logger logger = get_logger();
  if (action.action_type == DO_NOTHING) {
    RCLCPP_INFO(logger, "Robot to continue normal operation");
  } else if (cause == nullptr) {
    RCLCPP_WARN(logger,
                "Robot to stop due to invalid source. Either due to data not published yet, or to "
                "lack of new data received within the sensor timeout, or if impossible to "
                "transform data to base frame");
  } else if (action.action_type == STOP) {
    RCLCPP_INFO(logger, "Robot to stop due to %s polygon", action.polygon_name.c_str());
  } else if (action.action_type == SLOWDOWN) {
    RCLCPP_INFO(logger, "Robot to slowdown for %f percents due to %s polygon",
                cause->getSlowdownRatio() * 100, action.polygon_name.c_str());
  } else if (action.action_type == LIMIT) {
    RCLCPP_INFO(logger, "Robot to limit speed due to %s polygon", action.polygon_name.c_str());
  } else {
    RCLCPP_INFO(logger, "Robot to approach for %f seconds away from collision",
                cause->getTimeBeforeCollision());
  }
}

void CollisionMonitor::publishVelocity(const Action& robot_action,
                                       const std_msgs::msg::Header& header) {
  if (robot_action.req_vel.isZero()) {
    if (!robot_action_prev_.req_vel.isZero()) {
      stop_stamp_ = now();
    } else if (now() - stop_stamp_ > stop_pub_timeout_) {
      return;
    }
  }
  auto velocity = std::make_unique<geometry_msgs::msg::TwistStamped>();
  velocity->header = header;
  velocity->twist.linear.x = robot_action.req_vel.x;
  velocity->twist.linear.y = robot_action.req_vel.y;
  velocity->twist.angular.z = robot_action.req_vel.tw;
  cmd_vel_out_pub_->publish(std::move(velocity));
}

}  // namespace nav2_collision_monitor
