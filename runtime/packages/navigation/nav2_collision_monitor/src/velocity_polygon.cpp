// See velocity_polygon.hpp.
#include "nav2_collision_monitor/velocity_polygon.hpp"

#include <cmath>
#include <utility>

#include "read_parameters.hpp"
#include "zone_math.hpp"

namespace nav2_collision_monitor {

VelocityPolygon::VelocityPolygon(const nav2_util::LifecycleNode::WeakPtr& node,
                                 const std::string& polygon_name,
                                 const std::shared_ptr<tf2_ros::Buffer> tf_buffer,
                                 const std::string& base_frame_id,
                                 const tf2::Duration& transform_tolerance)
    : Polygon(node, polygon_name, tf_buffer, base_frame_id, transform_tolerance) {
  RCLCPP_INFO(logger_, "[%s]: Creating VelocityPolygon", polygon_name_.c_str());
}

VelocityPolygon::~VelocityPolygon() {
  RCLCPP_INFO(logger_, "[%s]: Destroying VelocityPolygon", polygon_name_.c_str());
}

bool VelocityPolygon::getParameters(std::string& polygon_sub_topic, std::string& polygon_pub_topic,
                                    std::string& footprint_topic) {
  const NodePtr node = locked(node_);
  clock_ = node->get_clock();
  if (!getCommonParameters(polygon_sub_topic, polygon_pub_topic, footprint_topic, false)) {
    return false;
  }
  try {
    const auto names = read_required<std::vector<std::string>>(
        node, polygon_name_ + ".velocity_polygons", rclcpp::PARAMETER_STRING_ARRAY);
    holonomic_ = read<bool>(node, polygon_name_ + ".holonomic", false);
    for (const std::string& name : names) {
      if (!readSubPolygon(name)) return false;
    }
  } catch (const std::exception& error) {
    RCLCPP_ERROR(logger_, "[%s]: Error while getting polygon parameters: %s", polygon_name_.c_str(),
                 error.what());
    return false;
  }
  return true;
}

bool VelocityPolygon::readSubPolygon(const std::string& name) {
  const NodePtr node = locked(node_);
  const std::string prefix = polygon_name_ + "." + name + ".";
  const auto number = [&](const char* which) {
    return read_required<double>(node, prefix + which, rclcpp::PARAMETER_DOUBLE);
  };
  SubPolygonParameter part;
  part.velocity_polygon_name_ = name;
  std::string text = read_required<std::string>(node, prefix + "points", rclcpp::PARAMETER_STRING);
  if (!getPolygonFromString(text, part.poly_)) return false;
  part.linear_min_ = number("linear_min");
  part.linear_max_ = number("linear_max");
  part.theta_min_ = number("theta_min");
  part.theta_max_ = number("theta_max");
  part.direction_end_angle_ =
      holonomic_ ? read<double>(node, prefix + "direction_end_angle", M_PI) : 0.0;
  part.direction_start_angle_ =
      holonomic_ ? read<double>(node, prefix + "direction_start_angle", -M_PI) : 0.0;
  sub_polygons_.push_back(std::move(part));
  return true;
}

void VelocityPolygon::updatePolygon(const Velocity& cmd_vel_in) {
  for (const SubPolygonParameter& part : sub_polygons_) {
    if (!isInRange(cmd_vel_in, part)) continue;
    poly_ = part.poly_;
    setPublished(poly_);
    return;
  }
  RCLCPP_WARN_THROTTLE(
      logger_, *clock_, 2000,
      "Velocity is not covered by any of the velocity polygons. x: %.3f y: %.3f tw: %.3f ",
      cmd_vel_in.x, cmd_vel_in.y, cmd_vel_in.tw);
}

bool VelocityPolygon::isInRange(const Velocity& cmd_vel_in,
                                const SubPolygonParameter& sub_polygon_param) {
  const SubPolygonParameter& part = sub_polygon_param;
  return is_in_range(cmd_vel_in,
                     {part.linear_min_, part.linear_max_, part.theta_min_, part.theta_max_,
                      part.direction_end_angle_, part.direction_start_angle_},
                     holonomic_);
}

}  // namespace nav2_collision_monitor
