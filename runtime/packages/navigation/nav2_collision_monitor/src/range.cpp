// See range.hpp.
#include "nav2_collision_monitor/range.hpp"

#include <cmath>

#include "read_parameters.hpp"
#include "zone_math.hpp"

namespace nav2_collision_monitor {
namespace {

constexpr double kLeastAngle = 1e-4;  // rad; bounds the number of points

bool is_measured(const sensor_msgs::msg::Range& data) {
  return data.range >= data.min_range && data.range <= data.max_range;
}

bool is_field_of_view(double angle) {
  return angle >= 0.0 && angle <= 2 * M_PI + 1e-3;
}

}  // namespace

Range::~Range() {
  RCLCPP_INFO(logger_, "[%s]: Destroying Range", source_name_.c_str());
}

void Range::configure() {
  RCLCPP_INFO(logger_, "[%s]: Creating Range", source_name_.c_str());
  Source::configure();
  std::string topic;
  getCommonParameters(topic);
  obstacles_angle_ =
      read_number(locked(node_), source_name_ + ".obstacles_angle", M_PI / 180, kLeastAngle);
  using Message = sensor_msgs::msg::Range;
  data_sub_ = locked(node_)->create_subscription<Message>(
      topic, rclcpp::SensorDataQoS(),
      [this](Message::ConstSharedPtr message) { dataCallback(message); });
}

bool Range::getData(const rclcpp::Time& curr_time, std::vector<Point>& data) {
  if (data_ == nullptr || !sourceValid(data_->header.stamp, curr_time)) return false;
  if (!is_measured(*data_)) {
    RCLCPP_DEBUG(logger_, "[%s]: Data range %fm is out of {%f..%f} sensor span. Ignoring...",
                 source_name_.c_str(), static_cast<double>(data_->range),
                 static_cast<double>(data_->min_range), static_cast<double>(data_->max_range));
    return false;
  }
  if (!is_field_of_view(data_->field_of_view)) {
    RCLCPP_ERROR(logger_, "[%s]: A field of view has to be from 0 to 2 pi, and is %f rad",
                 source_name_.c_str(), static_cast<double>(data_->field_of_view));
    return false;
  }
  tf2::Transform transform;
  if (!getTransform(curr_time, data_->header, transform)) return false;
  appendTransformed(arc_points(data_->range, data_->field_of_view, obstacles_angle_), transform,
                    data);
  return true;
}

void Range::dataCallback(sensor_msgs::msg::Range::ConstSharedPtr msg) {
  data_ = msg;
}

}  // namespace nav2_collision_monitor
