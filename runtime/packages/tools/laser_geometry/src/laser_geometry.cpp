// See laser_geometry.hpp.
#include "laser_geometry/laser_geometry.hpp"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

#include "rclcpp/duration.hpp"
#include "rclcpp/time.hpp"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Transform.h"
#include "tf2/LinearMath/Vector3.h"

namespace laser_geometry {
namespace {

using sensor_msgs::msg::LaserScan;
using sensor_msgs::msg::PointCloud2;
using sensor_msgs::msg::PointField;

void add_field(PointCloud2& cloud, const char* name, uint8_t datatype) {
  PointField field;
  field.name = name;
  field.offset = cloud.point_step;
  field.datatype = datatype;
  field.count = 1;
  cloud.fields.push_back(field);
  cloud.point_step += sizeof(float);
}

/// Puts values of four bytes behind each other.
class PointWriter {
 public:
  explicit PointWriter(PointCloud2& cloud) : data_(cloud.data) {}
  template <typename T>
  void put(T value) {
    static_assert(sizeof(T) == sizeof(float));
    uint8_t bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    data_.insert(data_.end(), bytes, bytes + sizeof(T));
  }
  void put(const tf2::Vector3& at) {
    put(static_cast<float>(at.x()));
    put(static_cast<float>(at.y()));
    put(static_cast<float>(at.z()));
  }

 private:
  std::vector<uint8_t>& data_;
};

/// `pose_at`: of the laser, for the number of a range.
void project(const LaserScan& scan, PointCloud2& cloud, double range_cutoff, int channels,
             const std::function<tf2::Transform(std::size_t)>& pose_at) {
  const bool has_intensity =
      (channels & channel_option::Intensity) != 0 && !scan.intensities.empty();
  const auto has = [channels](channel_option::ChannelOption one) { return (channels & one) != 0; };
  cloud = PointCloud2();
  cloud.header = scan.header;
  for (const char* name : {"x", "y", "z"}) add_field(cloud, name, PointField::FLOAT32);
  if (has_intensity) add_field(cloud, "intensity", PointField::FLOAT32);
  if (has(channel_option::Index)) add_field(cloud, "index", PointField::INT32);
  if (has(channel_option::Distance)) add_field(cloud, "distances", PointField::FLOAT32);
  if (has(channel_option::Timestamp)) add_field(cloud, "stamps", PointField::FLOAT32);
  if (has(channel_option::Viewpoint)) {
    for (const char* name : {"vp_x", "vp_y", "vp_z"}) add_field(cloud, name, PointField::FLOAT32);
  }
  const double end = range_cutoff < 0 ? static_cast<double>(scan.range_max) : range_cutoff;
  cloud.data.reserve(scan.ranges.size() * cloud.point_step);
  PointWriter point(cloud);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const float range = scan.ranges[i];
    if (!(range < end && range >= scan.range_min)) continue;
    const double angle =
        scan.angle_min + static_cast<double>(i) * static_cast<double>(scan.angle_increment);
    const tf2::Transform pose = pose_at(i);
    point.put(pose * tf2::Vector3(range * std::cos(angle), range * std::sin(angle), 0));
    // A scan may have fewer intensities than ranges.
    if (has_intensity) point.put(i < scan.intensities.size() ? scan.intensities[i] : 0.0F);
    if (has(channel_option::Index)) point.put(static_cast<int32_t>(i));
    if (has(channel_option::Distance)) point.put(range);
    if (has(channel_option::Timestamp)) point.put(static_cast<float>(i) * scan.time_increment);
    if (has(channel_option::Viewpoint)) point.put(pose.getOrigin());
    ++cloud.width;
  }
  cloud.height = 1;
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = false;
}

tf2::Transform pose_of(const geometry_msgs::msg::Transform& transform) {
  const auto& turn = transform.rotation;
  const auto& move = transform.translation;
  return tf2::Transform(tf2::Quaternion(turn.x, turn.y, turn.z, turn.w),
                        tf2::Vector3(move.x, move.y, move.z));
}

tf2::TimePoint time_of(const rclcpp::Time& time) {
  return tf2::TimePoint(std::chrono::nanoseconds(time.nanoseconds()));
}

}  // namespace

void LaserProjection::projectLaser(const LaserScan& scan_in, PointCloud2& cloud_out,
                                   double range_cutoff, int channel_options) const {
  project(scan_in, cloud_out, range_cutoff, channel_options,
          [](std::size_t) { return tf2::Transform::getIdentity(); });
}

void LaserProjection::transformLaserScanToPointCloud(const std::string& target_frame,
                                                     const LaserScan& scan_in,
                                                     PointCloud2& cloud_out, tf2::BufferCore& tf,
                                                     double range_cutoff,
                                                     int channel_options) const {
  const rclcpp::Time begin(scan_in.header.stamp);
  const double last = scan_in.ranges.empty() ? 0 : static_cast<double>(scan_in.ranges.size() - 1);
  const rclcpp::Time end =
      begin + rclcpp::Duration::from_seconds(last * static_cast<double>(scan_in.time_increment));
  const auto pose = [&](const rclcpp::Time& time) {
    return pose_of(
        tf.lookupTransform(target_frame, scan_in.header.frame_id, time_of(time)).transform);
  };
  const tf2::Transform first_pose = pose(begin);
  const tf2::Transform last_pose = pose(end);
  project(scan_in, cloud_out, range_cutoff, channel_options, [&](std::size_t i) {
    const double part = last == 0 ? 0 : static_cast<double>(i) / last;
    return tf2::Transform(first_pose.getRotation().slerp(last_pose.getRotation(), part),
                          first_pose.getOrigin().lerp(last_pose.getOrigin(), part));
  });
  cloud_out.header.frame_id = target_frame;
}

}  // namespace laser_geometry
