// See pointcloud.hpp.
#include "nav2_collision_monitor/pointcloud.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstring>

#include "read_parameters.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"

namespace nav2_collision_monitor {
namespace {

using sensor_msgs::msg::PointCloud2;
using sensor_msgs::msg::PointField;

bool has_field(const PointCloud2& cloud, const char* name) {
  return std::any_of(cloud.fields.begin(), cloud.fields.end(),
                     [name](const PointField& field) { return field.name == name; });
}

bool has_float(const PointCloud2& cloud, const char* name) {
  return std::any_of(cloud.fields.begin(), cloud.fields.end(), [&](const PointField& field) {
    return field.name == name && field.datatype == PointField::FLOAT32 &&
           static_cast<uint64_t>(field.offset) + sizeof(float) <= cloud.point_step;
  });
}

}  // namespace

PointCloud::~PointCloud() {
  RCLCPP_INFO(logger_, "[%s]: Destroying PointCloud", source_name_.c_str());
}

void PointCloud::configure() {
  RCLCPP_INFO(logger_, "[%s]: Creating PointCloud", source_name_.c_str());
  Source::configure();
  std::string topic;
  getCommonParameters(topic);
  const NodePtr node = locked(node_);
  min_height_ = read<double>(node, source_name_ + ".min_height", 0.05);
  max_height_ = read<double>(node, source_name_ + ".max_height", 0.5);
  min_range_ = read<double>(node, source_name_ + ".min_range", 0.0);
  use_global_height_ = read<bool>(node, source_name_ + ".use_global_height", false);
  data_sub_ = node->create_subscription<PointCloud2>(
      topic, rclcpp::SensorDataQoS(),
      [this](PointCloud2::ConstSharedPtr message) { dataCallback(message); });
}

bool PointCloud::isReadable() const {
  const PointCloud2& cloud = *data_;
  if (use_global_height_ && !has_field(cloud, "height")) {
    RCLCPP_ERROR(logger_, "[%s]: 'use_global_height' parameter true but height field not in cloud",
                 source_name_.c_str());
    return false;
  }
  for (const char* field : {"x", "y", "z", "height"}) {
    const bool is_needed = use_global_height_ || std::strcmp(field, "height") != 0;
    if (!is_needed || has_float(cloud, field)) continue;
    RCLCPP_ERROR(logger_, "[%s]: A cloud cannot be used: it has no field '%s' of type FLOAT32",
                 source_name_.c_str(), field);
    return false;
  }
  const uint64_t needed = static_cast<uint64_t>(cloud.width) * cloud.height * cloud.point_step;
  if (cloud.data.size() == needed) return true;
  RCLCPP_ERROR(logger_,
               "[%s]: A cloud cannot be used: it has %zu bytes, and width * height * point_step is "
               "%" PRIu64,
               source_name_.c_str(), cloud.data.size(), needed);
  return false;
}

bool PointCloud::getData(const rclcpp::Time& curr_time, std::vector<Point>& data) {
  tf2::Transform transform;
  if (data_ == nullptr || !sourceValid(data_->header.stamp, curr_time) ||
      !getTransform(curr_time, data_->header, transform) || !isReadable()) {
    return false;
  }
  using Values = sensor_msgs::PointCloud2ConstIterator<float>;
  Values y(*data_, "y");
  Values z(*data_, "z");
  Values height(*data_, use_global_height_ ? "height" : "z");
  for (Values x(*data_, "x"); x != x.end(); ++x, ++y, ++z, ++height) {
    const tf2::Vector3 point(*x, *y, *z);
    if (point.length() < min_range_) continue;
    const tf2::Vector3 moved = transform * point;
    const double above = use_global_height_ ? *height : moved.z();
    if (above >= min_height_ && above <= max_height_) data.push_back({moved.x(), moved.y()});
  }
  return true;
}

void PointCloud::dataCallback(PointCloud2::ConstSharedPtr msg) {
  data_ = msg;
}

}  // namespace nav2_collision_monitor
