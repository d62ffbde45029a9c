// See conversions.hpp. convert() sets a message from the one on the other side.
#include "conversions.hpp"

#include <algorithm>
#include <limits>

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/pose_array.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "geometry_msgs/msg/twist_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "gps_msgs/msg/gps_fix.hpp"
#include "rclcpp/serialization.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "sensor_msgs/msg/nav_sat_fix.hpp"
#include "sensor_msgs/msg/range.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

namespace ros_gz_bridge {
namespace {

namespace geometry = geometry_msgs::msg;

template <typename From, typename To>
void copy_xyz(const From& from, To& to) {
  to.x = from.x;
  to.y = from.y;
  to.z = from.z;
}

void convert(const geometry::Point& from, const Time&, geometry::Vector3& to) {
  copy_xyz(from, to);
}
void convert(const geometry::Vector3& from, const Time&, geometry::Point& to) {
  copy_xyz(from, to);
}

void convert(const geometry::Pose& from, const Time&, geometry::Transform& to) {
  copy_xyz(from.position, to.translation);
  to.rotation = from.orientation;
}
void convert(const geometry::Transform& from, const Time&, geometry::Pose& to) {
  copy_xyz(from.translation, to.position);
  to.orientation = from.rotation;
}
void convert(const geometry::Pose& from, const Time& now, geometry::TransformStamped& to) {
  to.header.stamp = now;
  convert(from, now, to.transform);
}
void convert(const geometry::TransformStamped& from, const Time& now, geometry::Pose& to) {
  convert(from.transform, now, to);
}

void convert(const geometry::PoseArray& from, const Time& now, tf2_msgs::msg::TFMessage& to) {
  for (const geometry::Pose& pose : from.poses) {
    to.transforms.emplace_back();
    to.transforms.back().header = from.header;
    convert(pose, now, to.transforms.back().transform);
  }
}
void convert(const tf2_msgs::msg::TFMessage& from, const Time& now, geometry::PoseArray& to) {
  to.header.stamp = now;
  if (!from.transforms.empty()) to.header = from.transforms.front().header;
  for (const geometry::TransformStamped& one : from.transforms) {
    to.poses.emplace_back();
    convert(one.transform, now, to.poses.back());
  }
}

// Types with a header around the message of the other side.
geometry::Pose& inner(geometry::PoseStamped& whole) {
  return whole.pose;
}
geometry::PoseWithCovariance& inner(geometry::PoseWithCovarianceStamped& whole) {
  return whole.pose;
}
geometry::Twist& inner(geometry::TwistStamped& whole) {
  return whole.twist;
}
geometry::TwistWithCovariance& inner(geometry::TwistWithCovarianceStamped& whole) {
  return whole.twist;
}
geometry::Wrench& inner(geometry::WrenchStamped& whole) {
  return whole.wrench;
}

template <typename Stamped, typename Inner>
auto convert(const Inner& from, const Time& now, Stamped& to)
    -> decltype(static_cast<Inner&>(inner(to)), void()) {
  to.header.stamp = now;
  inner(to) = from;
}
template <typename Stamped, typename Inner>
auto convert(const Stamped& from, const Time&, Inner& to)
    -> decltype(static_cast<Inner&>(inner(const_cast<Stamped&>(from))), void()) {
  Stamped copy = from;
  to = inner(copy);
}

void convert(const sensor_msgs::msg::NavSatFix& from, const Time&, gps_msgs::msg::GPSFix& to) {
  to.header = from.header;
  to.latitude = from.latitude;
  to.longitude = from.longitude;
  to.altitude = from.altitude;
  to.status.status = gps_msgs::msg::GPSStatus::STATUS_GBAS_FIX;
}
void convert(const gps_msgs::msg::GPSFix& from, const Time&, sensor_msgs::msg::NavSatFix& to) {
  to.header = from.header;
  to.latitude = from.latitude;
  to.longitude = from.longitude;
  to.altitude = from.altitude;
}

void convert(const sensor_msgs::msg::LaserScan& from, const Time&, sensor_msgs::msg::Range& to) {
  to.header = from.header;
  to.radiation_type = sensor_msgs::msg::Range::ULTRASOUND;
  to.field_of_view = from.angle_max - from.angle_min;
  to.min_range = from.range_min;
  to.max_range = from.range_max;
  to.range = std::numeric_limits<float>::infinity();
  for (const float range : from.ranges) to.range = std::min(to.range, range);
}
void convert(const sensor_msgs::msg::Range& from, const Time&, sensor_msgs::msg::LaserScan& to) {
  to.header = from.header;
  to.angle_min = -from.field_of_view / 2;
  to.angle_max = from.field_of_view / 2;
  to.range_min = from.min_range;
  to.range_max = from.max_range;
  to.ranges = {from.range};
}

template <typename From, typename To>
Bytes converted(const Bytes& bytes, const Time& now) {
  From from;
  To to;
  rclcpp::Serialization<From>().deserialize_message(&bytes, &from);
  convert(from, now, to);
  Bytes result;
  rclcpp::Serialization<To>().serialize_message(&to, &result);
  return result;
}

template <typename Ros, typename Gz>
constexpr Conversion between() {
  return {converted<Gz, Ros>, converted<Ros, Gz>};
}

}  // namespace

const Conversion kPointVector3 = between<geometry::Point, geometry::Vector3>();
const Conversion kPoseStampedPose = between<geometry::PoseStamped, geometry::Pose>();
const Conversion kTransformPose = between<geometry::Transform, geometry::Pose>();
const Conversion kTransformStampedPose = between<geometry::TransformStamped, geometry::Pose>();
const Conversion kPoseArrayTransforms = between<geometry::PoseArray, tf2_msgs::msg::TFMessage>();
const Conversion kPoseCovarianceStamped =
    between<geometry::PoseWithCovarianceStamped, geometry::PoseWithCovariance>();
const Conversion kTwistStampedTwist = between<geometry::TwistStamped, geometry::Twist>();
const Conversion kTwistCovarianceStamped =
    between<geometry::TwistWithCovarianceStamped, geometry::TwistWithCovariance>();
const Conversion kWrenchWrenchStamped = between<geometry::Wrench, geometry::WrenchStamped>();
const Conversion kGpsFixNavSat = between<gps_msgs::msg::GPSFix, sensor_msgs::msg::NavSatFix>();
const Conversion kRangeLaserScan = between<sensor_msgs::msg::Range, sensor_msgs::msg::LaserScan>();

}  // namespace ros_gz_bridge
