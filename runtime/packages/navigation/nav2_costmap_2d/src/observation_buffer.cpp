// See observation_buffer.hpp.
#include "nav2_costmap_2d/observation_buffer.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2/convert.h"

namespace nav2_costmap_2d {
namespace {

/// Whether the points of a cloud can be read: coordinates of the right type within them, and as
/// much data as it says. Any node can publish on the topic.
bool is_readable(const sensor_msgs::msg::PointCloud2& cloud) {
  using sensor_msgs::msg::PointField;
  const auto has = [&cloud](const char* name) {
    return std::any_of(cloud.fields.begin(), cloud.fields.end(), [&](const PointField& field) {
      return field.name == name && field.datatype == PointField::FLOAT32 &&
             static_cast<uint64_t>(field.offset) + sizeof(float) <= cloud.point_step;
    });
  };
  const uint64_t points = static_cast<uint64_t>(cloud.width) * cloud.height;
  return has("x") && has("y") && has("z") && cloud.data.size() == points * cloud.point_step;
}

/// The points of a cloud whose height is within limits.
sensor_msgs::msg::PointCloud2 within_heights(const sensor_msgs::msg::PointCloud2& cloud,
                                             double lowest, double highest) {
  sensor_msgs::msg::PointCloud2 some;
  some.header = cloud.header;
  some.fields = cloud.fields;
  some.is_bigendian = cloud.is_bigendian;
  some.point_step = cloud.point_step;
  some.is_dense = cloud.is_dense;
  some.height = 1;
  some.data.reserve(cloud.data.size());
  sensor_msgs::PointCloud2ConstIterator<float> z(cloud, "z");
  const size_t points = static_cast<size_t>(cloud.width) * cloud.height;
  for (size_t i = 0; i < points; ++i, ++z) {
    if (!(*z <= highest && *z >= lowest)) continue;
    const auto first = cloud.data.begin() + static_cast<ptrdiff_t>(i * cloud.point_step);
    some.data.insert(some.data.end(), first, first + cloud.point_step);
    ++some.width;
  }
  some.row_step = some.width * some.point_step;
  return some;
}

}  // namespace

ObservationBuffer::ObservationBuffer(const nav2_util::LifecycleNode::WeakPtr& parent,
                                     std::string topic_name, double observation_keep_time,
                                     double expected_update_rate, double min_obstacle_height,
                                     double max_obstacle_height, double obstacle_max_range,
                                     double obstacle_min_range, double raytrace_max_range,
                                     double raytrace_min_range, tf2_ros::Buffer& tf2_buffer,
                                     std::string global_frame, std::string sensor_frame,
                                     tf2::Duration tf_tolerance)
    : tf2_buffer_(tf2_buffer),
      observation_keep_time_(rclcpp::Duration::from_seconds(observation_keep_time)),
      expected_update_rate_(rclcpp::Duration::from_seconds(expected_update_rate)),
      global_frame_(std::move(global_frame)),
      sensor_frame_(std::move(sensor_frame)),
      topic_name_(std::move(topic_name)),
      min_obstacle_height_(min_obstacle_height),
      max_obstacle_height_(max_obstacle_height),
      obstacle_max_range_(obstacle_max_range),
      obstacle_min_range_(obstacle_min_range),
      raytrace_max_range_(raytrace_max_range),
      raytrace_min_range_(raytrace_min_range),
      tf_tolerance_(tf_tolerance) {
  const auto node = parent.lock();
  clock_ = node->get_clock();
  logger_ = node->get_logger();
  last_updated_ = clock_->now();
}

ObservationBuffer::~ObservationBuffer() = default;

void ObservationBuffer::bufferCloud(const sensor_msgs::msg::PointCloud2& cloud) {
  if (!is_readable(cloud)) {
    RCLCPP_WARN_THROTTLE(
        logger_, *clock_, 5000,
        "A cloud on %s is ignored: it needs the fields x, y and z of type float32, "
        "and as much data as it says.",
        topic_name_.c_str());
    return;
  }
  const std::string frame = sensor_frame_.empty() ? cloud.header.frame_id : sensor_frame_;
  try {
    geometry_msgs::msg::PointStamped origin;
    origin.header.stamp = cloud.header.stamp;
    origin.header.frame_id = frame;
    geometry_msgs::msg::PointStamped global_origin;
    tf2_buffer_.transform(origin, global_origin, global_frame_, tf_tolerance_);
    sensor_msgs::msg::PointCloud2 global_cloud;
    tf2_buffer_.transform(cloud, global_cloud, global_frame_, tf_tolerance_);
    global_cloud.header.stamp = cloud.header.stamp;
    observation_list_.emplace_front(
        global_origin.point,
        within_heights(global_cloud, min_obstacle_height_, max_obstacle_height_),
        obstacle_max_range_, obstacle_min_range_, raytrace_max_range_, raytrace_min_range_);
  } catch (const tf2::TransformException& error) {
    RCLCPP_ERROR(logger_,
                 "TF Exception that should never happen for sensor frame: %s, cloud frame: %s, %s",
                 sensor_frame_.c_str(), cloud.header.frame_id.c_str(), error.what());
    return;
  }
  last_updated_ = clock_->now();
  purgeStaleObservations();
}

void ObservationBuffer::getObservations(std::vector<Observation>& observations) {
  purgeStaleObservations();
  observations.insert(observations.end(), observation_list_.begin(), observation_list_.end());
}

void ObservationBuffer::purgeStaleObservations() {
  if (observation_list_.empty()) return;
  auto stale = std::next(observation_list_.begin());
  if (observation_keep_time_ != rclcpp::Duration(0, 0)) {
    const rclcpp::Time now = clock_->now();
    stale = observation_list_.begin();
    while (stale != observation_list_.end() &&
           now - rclcpp::Time(stale->cloud_->header.stamp, now.get_clock_type()) <=
               observation_keep_time_) {
      ++stale;
    }
  }
  observation_list_.erase(stale, observation_list_.end());
}

bool ObservationBuffer::isCurrent() const {
  if (expected_update_rate_ == rclcpp::Duration(0, 0)) return true;
  const rclcpp::Duration silence = clock_->now() - last_updated_;
  if (silence <= expected_update_rate_) return true;
  RCLCPP_WARN(logger_,
              "The %s observation buffer has not been updated for %.2f seconds, and it should be "
              "updated every %.2f seconds.",
              topic_name_.c_str(), silence.seconds(), expected_update_rate_.seconds());
  return false;
}

void ObservationBuffer::resetLastUpdated() {
  last_updated_ = clock_->now();
}

}  // namespace nav2_costmap_2d
