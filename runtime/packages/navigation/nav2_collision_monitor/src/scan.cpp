// See scan.hpp.
#include "nav2_collision_monitor/scan.hpp"

#include <cmath>

#include "read_parameters.hpp"

namespace nav2_collision_monitor {

using sensor_msgs::msg::LaserScan;

Scan::~Scan() {
  RCLCPP_INFO(logger_, "[%s]: Destroying Scan", source_name_.c_str());
}

void Scan::configure() {
  RCLCPP_INFO(logger_, "[%s]: Creating Scan", source_name_.c_str());
  Source::configure();
  std::string topic;
  getCommonParameters(topic);
  data_sub_ = locked(node_)->create_subscription<LaserScan>(
      topic, rclcpp::SensorDataQoS(),
      [this](LaserScan::ConstSharedPtr message) { dataCallback(message); });
}

bool Scan::getData(const rclcpp::Time& curr_time, std::vector<Point>& data) {
  tf2::Transform transform;
  if (data_ == nullptr || !sourceValid(data_->header.stamp, curr_time) ||
      !getTransform(curr_time, data_->header, transform)) {
    return false;
  }
  std::vector<Point> points;
  float angle = data_->angle_min;
  for (const float range : data_->ranges) {
    if (range >= data_->range_min && range <= data_->range_max) {
      points.push_back({range * std::cos(angle), range * std::sin(angle)});
    }
    angle += data_->angle_increment;
  }
  appendTransformed(points, transform, data);
  return true;
}

void Scan::dataCallback(LaserScan::ConstSharedPtr msg) {
  data_ = msg;
}

}  // namespace nav2_collision_monitor
