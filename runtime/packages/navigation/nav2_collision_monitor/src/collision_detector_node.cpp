// See collision_detector_node.hpp.
#include "nav2_collision_monitor/collision_detector_node.hpp"

#include <utility>

#include "nav2_collision_monitor/velocity_polygon.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "read_parameters.hpp"

namespace nav2_collision_monitor {

using nav2_util::CallbackReturn;

CollisionDetector::CollisionDetector(const rclcpp::NodeOptions& options)
    : nav2_util::LifecycleNode("collision_detector", "", options) {}

CollisionDetector::~CollisionDetector() = default;

CallbackReturn CollisionDetector::on_configure(const rclcpp_lifecycle::State& state) {
  RCLCPP_INFO(get_logger(), "Configuring");
  state_pub_ = create_publisher<State>("collision_detector_state", rclcpp::SystemDefaultsQoS());
  collision_points_marker_pub_ = create_publisher<MarkerArray>("~/collision_points_marker", 1);
  if (!getParameters()) {
    on_cleanup(state);
    return CallbackReturn::FAILURE;
  }
  return CallbackReturn::SUCCESS;
}

bool CollisionDetector::getParameters() {
  const NodePtr node = shared_from_this();
  try {
    frequency_ = read_number(node, "frequency", 10.0, 1e-3);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "Error while getting parameters: %s", error.what());
    return false;
  }
  if (!zones_.configure(node)) return false;
  for (const auto& polygon : zones_.polygons) {
    if (std::dynamic_pointer_cast<VelocityPolygon>(polygon)) {
      RCLCPP_ERROR(
          get_logger(),
          "[%s]: The collision detector knows no velocity, so it does not support the type "
          "\"velocity_polygon\". Use \"polygon\" or \"circle\".",
          polygon->getName().c_str());
      return false;
    }
    if (polygon->getActionType() == DO_NOTHING) continue;
    RCLCPP_ERROR(get_logger(),
                 "[%s]: The action_type of the polygon is different than \"none\" which is not "
                 "supported in the collision detector.",
                 polygon->getName().c_str());
    return false;
  }
  return true;
}

CallbackReturn CollisionDetector::on_activate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Activating");
  state_pub_->on_activate();
  collision_points_marker_pub_->on_activate();
  zones_.activate();
  timer_ =
      rclcpp::create_timer(shared_from_this(), get_clock(),
                           rclcpp::Duration::from_seconds(1.0 / frequency_), [this] { process(); });
  createBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CollisionDetector::on_deactivate(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Deactivating");
  timer_.reset();
  state_pub_->on_deactivate();
  collision_points_marker_pub_->on_deactivate();
  zones_.deactivate();
  destroyBond();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CollisionDetector::on_cleanup(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Cleaning up");
  state_pub_.reset();
  collision_points_marker_pub_.reset();
  zones_.clear();
  return CallbackReturn::SUCCESS;
}

CallbackReturn CollisionDetector::on_shutdown(const rclcpp_lifecycle::State&) {
  RCLCPP_INFO(get_logger(), "Shutting down");
  return CallbackReturn::SUCCESS;
}

void CollisionDetector::process() {
  const std::vector<Point> points = collectPoints();
  publishPoints(points);
  auto state = std::make_unique<State>();
  for (const auto& polygon : zones_.polygons) {
    if (!polygon->getEnabled()) continue;
    // A shape that was published in another frame moves when the robot does.
    polygon->updatePolygon(Velocity{});
    state->polygons.push_back(polygon->getName());
    state->detections.push_back(polygon->isShapeSet() &&
                                polygon->getPointsInside(points) >= polygon->getMinPoints());
  }
  state_pub_->publish(std::move(state));
  zones_.publish();
}

std::vector<Point> CollisionDetector::collectPoints() {
  std::vector<Point> points;
  const rclcpp::Time time = now();
  for (const auto& source : zones_.sources) {
    if (!source->getEnabled() || readPoints(*source, time, points) ||
        source->getSourceTimeout().nanoseconds() == 0) {
      continue;
    }
    RCLCPP_WARN(get_logger(),
                "Invalid source %s detected. Either due to data not published yet, or to lack of "
                "new data received within the sensor timeout, or if impossible to transform data "
                "to base frame",
                source->getSourceName().c_str());
  }
  return points;
}

void CollisionDetector::publishPoints(const std::vector<Point>& points) {
  if (collision_points_marker_pub_->get_subscription_count() == 0) return;
  auto markers = std::make_unique<MarkerArray>();
  markers->markers.push_back(pointsMarker(zones_.base_frame_id, "collision_points", points));
  collision_points_marker_pub_->publish(std::move(markers));
}

}  // namespace nav2_collision_monitor

RCLCPP_COMPONENTS_REGISTER_NODE(nav2_collision_monitor::CollisionDetector)
