// See polygon_source.hpp.
#include "nav2_collision_monitor/polygon_source.hpp"

#include <algorithm>
#include <cmath>

#include "read_parameters.hpp"
#include "zone_math.hpp"

namespace nav2_collision_monitor {
namespace {

using geometry_msgs::msg::PolygonInstanceStamped;

// Bounds the memory of a source whose numbers never repeat.
constexpr size_t kMostPolygons = 1000;
constexpr double kLeastDistance = 1e-3;  // m

std::vector<Point> vertices_of(const PolygonInstanceStamped& message) {
  std::vector<Point> vertices;
  for (const auto& vertex : message.polygon.polygon.points) {
    if (std::isfinite(vertex.x) && std::isfinite(vertex.y))
      vertices.push_back({vertex.x, vertex.y});
  }
  return vertices;
}

}  // namespace

PolygonSource::~PolygonSource() = default;

void PolygonSource::configure() {
  Source::configure();
  std::string topic;
  getCommonParameters(topic);
  sampling_distance_ =
      read_number(locked(node_), source_name_ + ".sampling_distance", 0.1, kLeastDistance);
  data_sub_ = locked(node_)->create_subscription<PolygonInstanceStamped>(
      topic, rclcpp::SensorDataQoS(),
      [this](PolygonInstanceStamped::ConstSharedPtr message) { dataCallback(message); });
}

void PolygonSource::dropStale(const rclcpp::Time& curr_time) {
  if (source_timeout_.nanoseconds() == 0) return;
  const auto is_stale = [&](const PolygonInstanceStamped& message) {
    return curr_time - rclcpp::Time(message.header.stamp) > source_timeout_;
  };
  data_.erase(std::remove_if(data_.begin(), data_.end(), is_stale), data_.end());
}

bool PolygonSource::getData(const rclcpp::Time& curr_time, std::vector<Point>& data) {
  dropStale(curr_time);
  if (data_.empty()) return false;
  for (const PolygonInstanceStamped& message : data_) {
    tf2::Transform transform;
    if (!getTransform(curr_time, message.header, transform)) return false;
    std::vector<Point> vertices;
    appendTransformed(vertices_of(message), transform, vertices);
    const std::vector<Point> points = outline_points(vertices, sampling_distance_);
    data.insert(data.end(), points.begin(), points.end());
  }
  return true;
}

void PolygonSource::dataCallback(PolygonInstanceStamped::ConstSharedPtr msg) {
  // It would stay, and stop the robot.
  if (msg->header.stamp.sec < 0) {
    RCLCPP_ERROR(logger_, "[%s]: A polygon of a negative time is ignored", source_name_.c_str());
    return;
  }
  const auto same = std::find_if(
      data_.begin(), data_.end(),
      [&msg](const PolygonInstanceStamped& older) { return older.polygon.id == msg->polygon.id; });
  if (same != data_.end()) {
    *same = *msg;
    return;
  }
  const auto is_older = [](const PolygonInstanceStamped& a, const PolygonInstanceStamped& b) {
    return rclcpp::Time(a.header.stamp) < rclcpp::Time(b.header.stamp);
  };
  if (data_.size() == kMostPolygons) {
    data_.erase(std::min_element(data_.begin(), data_.end(), is_older));
  }
  data_.push_back(*msg);
}

}  // namespace nav2_collision_monitor
