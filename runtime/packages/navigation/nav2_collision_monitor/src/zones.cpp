// See zones.hpp.
#include "nav2_collision_monitor/zones.hpp"

#include "nav2_collision_monitor/circle.hpp"
#include "nav2_collision_monitor/pointcloud.hpp"
#include "nav2_collision_monitor/polygon_source.hpp"
#include "nav2_collision_monitor/range.hpp"
#include "nav2_collision_monitor/scan.hpp"
#include "nav2_collision_monitor/velocity_polygon.hpp"
#include "read_parameters.hpp"
#include "tf2_ros/create_timer_ros.h"

namespace nav2_collision_monitor {
namespace {

using Names = std::vector<std::string>;

template <typename... Arguments>
std::shared_ptr<Polygon> make_polygon(const std::string& type, const Arguments&... arguments) {
  if (type == "polygon") return std::make_shared<Polygon>(arguments...);
  if (type == "circle") return std::make_shared<Circle>(arguments...);
  if (type == "velocity_polygon") return std::make_shared<VelocityPolygon>(arguments...);
  return nullptr;
}

template <typename... Arguments>
std::shared_ptr<Source> make_source(const std::string& type, const Arguments&... arguments) {
  if (type == "scan") return std::make_shared<Scan>(arguments...);
  if (type == "pointcloud") return std::make_shared<PointCloud>(arguments...);
  if (type == "range") return std::make_shared<Range>(arguments...);
  if (type == "polygon") return std::make_shared<PolygonSource>(arguments...);
  return nullptr;
}

}  // namespace

bool Zones::configure(const NodePtr& node) {
  tf_buffer_ = std::make_shared<tf2_ros::Buffer>(node->get_clock());
  tf_buffer_->setCreateTimerInterface(std::make_shared<tf2_ros::CreateTimerROS>(
      node->get_node_base_interface(), node->get_node_timers_interface()));
  tf_listener_ = std::make_shared<tf2_ros::TransformListener>(*tf_buffer_, node, true);
  try {
    base_frame_id = read<std::string>(node, "base_frame_id", "base_footprint");
    transform_tolerance_ = tf2::durationFromSec(read_number(node, "transform_tolerance", 0.1, 0.0));
    return configureSources(node) && configurePolygons(node);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(node->get_logger(), "Error while getting parameters: %s", error.what());
    return false;
  }
}

bool Zones::configureSources(const NodePtr& node) {
  const auto odom_frame_id = read<std::string>(node, "odom_frame_id", "odom");
  const auto timeout =
      rclcpp::Duration::from_seconds(read_number(node, "source_timeout", 2.0, 0.0));
  const bool base_shift_correction = read<bool>(node, "base_shift_correction", true);
  const auto names =
      read_required<Names>(node, "observation_sources", rclcpp::PARAMETER_STRING_ARRAY);
  for (const std::string& name : names) {
    const auto type = read<std::string>(node, name + ".type", "scan");
    const std::shared_ptr<Source> source =
        make_source(type, nav2_util::LifecycleNode::WeakPtr(node), name, tf_buffer_, base_frame_id,
                    odom_frame_id, transform_tolerance_, timeout, base_shift_correction);
    if (!source) {
      RCLCPP_ERROR(node->get_logger(), "[%s]: Unknown source type: %s", name.c_str(), type.c_str());
      return false;
    }
    source->configure();
    sources.push_back(source);
  }
  return true;
}

bool Zones::configurePolygons(const NodePtr& node) {
  const auto names = read_required<Names>(node, "polygons", rclcpp::PARAMETER_STRING_ARRAY);
  for (const std::string& name : names) {
    const auto type = read_required<std::string>(node, name + ".type", rclcpp::PARAMETER_STRING);
    const std::shared_ptr<Polygon> polygon =
        make_polygon(type, nav2_util::LifecycleNode::WeakPtr(node), name, tf_buffer_, base_frame_id,
                     transform_tolerance_);
    if (!polygon) {
      RCLCPP_ERROR(node->get_logger(), "[%s]: Unknown polygon type: %s", name.c_str(),
                   type.c_str());
      return false;
    }
    if (!polygon->configure()) return false;
    polygons.push_back(polygon);
  }
  return true;
}

void Zones::activate() {
  for (const auto& polygon : polygons) polygon->activate();
}

void Zones::deactivate() {
  for (const auto& polygon : polygons) polygon->deactivate();
}

void Zones::clear() {
  polygons.clear();
  sources.clear();
  tf_listener_.reset();
  tf_buffer_.reset();
}

void Zones::publish() const {
  for (const auto& polygon : polygons) {
    if (polygon->getEnabled()) polygon->publish();
  }
}

bool readPoints(Source& source, const rclcpp::Time& time, std::vector<Point>& points) {
  try {
    return source.getData(time, points);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(rclcpp::get_logger("collision_monitor"),
                 "[%s]: The data of this source cannot be used: %s", source.getSourceName().c_str(),
                 error.what());
    return false;
  }
}

visualization_msgs::msg::Marker pointsMarker(const std::string& frame_id, const std::string& ns,
                                             const std::vector<Point>& points) {
  visualization_msgs::msg::Marker marker;
  marker.header.frame_id = frame_id;
  marker.ns = ns;
  marker.type = visualization_msgs::msg::Marker::POINTS;
  marker.action = visualization_msgs::msg::Marker::ADD;
  marker.scale.x = 0.02;
  marker.scale.y = 0.02;
  marker.color.r = 1.0F;
  marker.color.a = 1.0F;
  marker.frame_locked = true;
  for (const Point& point : points) {
    geometry_msgs::msg::Point shown;
    shown.x = point.x;
    shown.y = point.y;
    marker.points.push_back(shown);
  }
  return marker;
}

}  // namespace nav2_collision_monitor
