// See circle.hpp.
#include "nav2_collision_monitor/circle.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "read_parameters.hpp"

namespace nav2_collision_monitor {
namespace {

bool is_radius(double radius) {
  return std::isfinite(radius) && radius > 0.0;
}

}  // namespace

Circle::Circle(const nav2_util::LifecycleNode::WeakPtr& node, const std::string& polygon_name,
               const std::shared_ptr<tf2_ros::Buffer> tf_buffer, const std::string& base_frame_id,
               const tf2::Duration& transform_tolerance)
    : Polygon(node, polygon_name, tf_buffer, base_frame_id, transform_tolerance) {
  RCLCPP_INFO(logger_, "[%s]: Creating Circle", polygon_name_.c_str());
}

Circle::~Circle() {
  RCLCPP_INFO(logger_, "[%s]: Destroying Circle", polygon_name_.c_str());
}

void Circle::getPolygon(std::vector<Point>& poly) const {
  constexpr int kVertices = 16;
  poly.clear();
  for (int i = 0; i < kVertices; ++i) {
    const double angle = 2 * M_PI * i / kVertices;
    poly.push_back({radius_ * std::cos(angle), radius_ * std::sin(angle)});
  }
}

int Circle::getPointsInside(const std::vector<Point>& points) const {
  return static_cast<int>(std::count_if(points.begin(), points.end(), [this](const Point& point) {
    return point.x * point.x + point.y * point.y < radius_squared_;
  }));
}

bool Circle::isShapeSet() {
  if (radius_squared_ >= 0.0) return true;
  RCLCPP_WARN(logger_, "[%s]: Circle radius is not set yet", polygon_name_.c_str());
  return false;
}

bool Circle::getParameters(std::string& polygon_sub_topic, std::string& polygon_pub_topic,
                           std::string& footprint_topic) {
  polygon_sub_topic.clear();
  bool is_dynamic = true;
  try {
    const std::string name = polygon_name_ + ".radius";
    const double radius = read_required<double>(locked(node_), name, rclcpp::PARAMETER_DOUBLE);
    if (!is_radius(radius)) {
      throw std::runtime_error("parameter '" + name + "' has to be a number above 0, and is " +
                               std::to_string(radius));
    }
    updatePolygon(radius);
    is_dynamic = false;
  } catch (const rclcpp::exceptions::ParameterUninitializedException&) {
    RCLCPP_INFO(logger_,
                "[%s]: Polygon circle radius is not defined. Using dynamic subscription instead.",
                polygon_name_.c_str());
  }
  const bool is_read =
      getCommonParameters(polygon_sub_topic, polygon_pub_topic, footprint_topic, is_dynamic);
  if (!is_read && is_dynamic && polygon_sub_topic.empty()) {
    RCLCPP_ERROR(logger_,
                 "[%s]: Error while getting circle parameters: static radius and sub topic both "
                 "not defined",
                 polygon_name_.c_str());
  }
  // A circle cannot have a footprint.
  footprint_topic.clear();
  return is_read;
}

void Circle::createSubscription(std::string& polygon_sub_topic) {
  if (polygon_sub_topic.empty()) return;
  RCLCPP_INFO(logger_, "[%s]: Subscribing on %s topic for polygon", polygon_name_.c_str(),
              polygon_sub_topic.c_str());
  using Float32 = std_msgs::msg::Float32;
  radius_sub_ = locked(node_)->create_subscription<Float32>(
      polygon_sub_topic, shapeQoS(),
      [this](Float32::ConstSharedPtr message) { radiusCallback(message); });
}

void Circle::updatePolygon(double radius) {
  radius_ = radius;
  radius_squared_ = radius * radius;
  std::vector<Point> points;
  getPolygon(points);
  setPublished(points);
}

void Circle::radiusCallback(std_msgs::msg::Float32::ConstSharedPtr msg) {
  RCLCPP_INFO(logger_, "[%s]: Polygon circle radius update has been arrived",
              polygon_name_.c_str());
  if (is_radius(msg->data)) return updatePolygon(static_cast<double>(msg->data));
  RCLCPP_ERROR(logger_, "[%s]: A radius has to be a number above 0, and is %f",
               polygon_name_.c_str(), static_cast<double>(msg->data));
}

}  // namespace nav2_collision_monitor
