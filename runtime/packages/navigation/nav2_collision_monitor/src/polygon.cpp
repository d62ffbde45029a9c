// See polygon.hpp. Its parameters are read in polygon_parameters.cpp.
#include "nav2_collision_monitor/polygon.hpp"

#include <algorithm>
#include <utility>

#include "nav2_util/robot_utils.hpp"
#include "read_parameters.hpp"
#include "zone_math.hpp"

namespace nav2_collision_monitor {

using geometry_msgs::msg::PolygonStamped;

Polygon::Polygon(const nav2_util::LifecycleNode::WeakPtr& node, const std::string& polygon_name,
                 const std::shared_ptr<tf2_ros::Buffer> tf_buffer, const std::string& base_frame_id,
                 const tf2::Duration& transform_tolerance)
    : node_(node),
      polygon_name_(polygon_name),
      tf_buffer_(tf_buffer),
      base_frame_id_(base_frame_id),
      transform_tolerance_(transform_tolerance) {
  RCLCPP_INFO(logger_, "[%s]: Creating Polygon", polygon_name_.c_str());
}

Polygon::~Polygon() {
  RCLCPP_INFO(logger_, "[%s]: Destroying Polygon", polygon_name_.c_str());
}

bool Polygon::configure() {
  const NodePtr node = locked(node_);
  std::string shape_topic;
  std::string output_topic;
  std::string footprint_topic;
  if (!getParameters(shape_topic, output_topic, footprint_topic)) return false;
  createSubscription(shape_topic);
  if (!footprint_topic.empty()) {
    RCLCPP_INFO(logger_, "[%s]: Making footprint subscriber on %s topic", polygon_name_.c_str(),
                footprint_topic.c_str());
    footprint_sub_ = std::make_unique<nav2_costmap_2d::FootprintSubscriber>(
        nav2_util::LifecycleNode::WeakPtr(node), footprint_topic, *tf_buffer_, base_frame_id_,
        tf2::durationToSec(transform_tolerance_));
  }
  if (visualize_) {
    std::vector<Point> points;
    getPolygon(points);
    polygon_.header.frame_id = base_frame_id_;
    setPublished(points);
    polygon_pub_ =
        node->create_publisher<PolygonStamped>(output_topic, rclcpp::SystemDefaultsQoS());
  }
  dyn_params_handler_ =
      node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(std::move(parameters));
      });
  return true;
}

void Polygon::activate() {
  if (visualize_) polygon_pub_->on_activate();
}

void Polygon::deactivate() {
  if (visualize_) polygon_pub_->on_deactivate();
}

void Polygon::getPolygon(std::vector<Point>& poly) const {
  poly = poly_;
}

bool Polygon::isShapeSet() {
  if (!poly_.empty()) return true;
  RCLCPP_WARN(logger_, "[%s]: Polygon shape is not set yet", polygon_name_.c_str());
  return false;
}

bool Polygon::isPointInside(const Point& point) const {
  return is_inside(poly_, point);
}

int Polygon::getPointsInside(const std::vector<Point>& points) const {
  return count_inside(poly_, points);
}

int Polygon::getPointsInside(const SourcePoints& sources_collision_points_map) const {
  int sum = 0;
  for (const std::string& source : sources_names_) {
    const auto found = sources_collision_points_map.find(source);
    if (found != sources_collision_points_map.end()) sum += getPointsInside(found->second);
  }
  return sum;
}

double Polygon::getCollisionTime(const SourcePoints& sources_collision_points_map,
                                 const Velocity& velocity) const {
  std::vector<Point> obstacles;
  for (const std::string& source : sources_names_) {
    const auto found = sources_collision_points_map.find(source);
    if (found == sources_collision_points_map.end()) continue;
    obstacles.insert(obstacles.end(), found->second.begin(), found->second.end());
  }
  return time_to_collision(
      obstacles, velocity, {time_before_collision_, simulation_time_step_, min_points_},
      [this](const std::vector<Point>& points) { return getPointsInside(points); });
}

void Polygon::publish() {
  if (!visualize_) return;
  polygon_.header.stamp = locked(node_)->now();
  polygon_pub_->publish(std::make_unique<PolygonStamped>(polygon_));
}

void Polygon::setPublished(const std::vector<Point>& points) {
  polygon_.polygon.points.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    polygon_.polygon.points[i].x = static_cast<float>(points[i].x);
    polygon_.polygon.points[i].y = static_cast<float>(points[i].y);
  }
}

rclcpp::QoS Polygon::shapeQoS() const {
  rclcpp::QoS qos = rclcpp::SystemDefaultsQoS();
  if (polygon_subscribe_transient_local_) qos.transient_local();
  return qos;
}

void Polygon::createSubscription(std::string& polygon_sub_topic) {
  if (polygon_sub_topic.empty()) return;
  RCLCPP_INFO(logger_, "[%s]: Subscribing on %s topic for polygon", polygon_name_.c_str(),
              polygon_sub_topic.c_str());
  polygon_sub_ = locked(node_)->create_subscription<PolygonStamped>(
      polygon_sub_topic, shapeQoS(),
      [this](PolygonStamped::ConstSharedPtr message) { polygonCallback(message); });
}

void Polygon::polygonCallback(PolygonStamped::ConstSharedPtr msg) {
  RCLCPP_INFO(logger_, "[%s]: Polygon shape update has been arrived", polygon_name_.c_str());
  updatePolygon(msg);
}

void Polygon::updatePolygon(PolygonStamped::ConstSharedPtr msg) {
  if (msg->polygon.points.size() < 3) {
    RCLCPP_ERROR(logger_, "[%s]: Polygon should have at least 3 points", polygon_name_.c_str());
    return;
  }
  if (toRobotFrame(*msg)) polygon_ = *msg;
}

void Polygon::updatePolygon(const Velocity&) {
  if (footprint_sub_ != nullptr) {
    takeFootprint();
  } else if (!polygon_.header.frame_id.empty() && polygon_.header.frame_id != base_frame_id_) {
    toRobotFrame(polygon_);
  }
}

void Polygon::takeFootprint() {
  std::vector<geometry_msgs::msg::Point> footprint;
  std_msgs::msg::Header header;
  // Without a new one the last is still right: it moves with the robot.
  try {
    if (!footprint_sub_->getFootprintInRobotFrame(footprint, header)) return;
  } catch (const std::exception& error) {
    RCLCPP_ERROR(logger_, "[%s]: A footprint cannot be used: %s", polygon_name_.c_str(),
                 error.what());
    return;
  }
  poly_.clear();
  for (const auto& vertex : footprint) poly_.push_back({vertex.x, vertex.y});
  polygon_.header.frame_id = base_frame_id_;
  setPublished(poly_);
}

bool Polygon::toRobotFrame(const PolygonStamped& shape) {
  tf2::Transform transform;
  if (!nav2_util::getTransform(shape.header.frame_id, base_frame_id_, transform_tolerance_,
                               tf_buffer_, transform)) {
    return false;
  }
  poly_.clear();
  for (const auto& vertex : shape.polygon.points) {
    const tf2::Vector3 moved = transform * tf2::Vector3(vertex.x, vertex.y, 0.0);
    poly_.push_back({moved.x(), moved.y()});
  }
  return true;
}

rcl_interfaces::msg::SetParametersResult Polygon::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL &&
        parameter.get_name() == polygon_name_ + ".enabled") {
      enabled_ = parameter.as_bool();
    }
  }
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  return result;
}

}  // namespace nav2_collision_monitor
