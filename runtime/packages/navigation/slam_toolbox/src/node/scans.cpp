// See slam_toolbox_common.hpp. Scans are read, added, and answered by a pose and a transform.
#include <cmath>
#include <utility>

#include "node/slam_toolbox_common.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace slam_toolbox {
namespace {

Pose planar(const tf2::Transform& transform) {
  return {transform.getOrigin().x(), transform.getOrigin().y(),
          tf2::getYaw(transform.getRotation())};
}

tf2::Transform transform_of(const Pose& pose) {
  tf2::Quaternion rotation;
  rotation.setRPY(0.0, 0.0, pose.yaw);
  return tf2::Transform(rotation, tf2::Vector3(pose.x, pose.y, 0.0));
}

}  // namespace

void SlamToolbox::on_scan(const LaserScan& message) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  Pose odometry;
  try {
    tf2::Transform transform;
    tf2::fromMsg(buffer_
                     ->lookupTransform(parameters_.odom_frame, parameters_.base_frame,
                                       tf2_ros::fromMsg(message.header.stamp))
                     .transform,
                 transform);
    odometry = planar(transform);
  } catch (const tf2::TransformException&) {
    RCLCPP_WARN_THROTTLE(get_logger(), *get_clock(), 2000, "Failed to compute odom pose");
    return;
  }
  if (!is_usable(odometry)) {
    RCLCPP_ERROR_THROTTLE(get_logger(), *get_clock(), 2000,
                          "An odom pose that is not finite or too far away is ignored");
    return;
  }
  std::optional<Scan> scan = read(message);
  if (!scan) return;
  scan->odometry = scan->corrected = odometry;
  scan_stamp_ = message.header.stamp;
  has_scan_ = true;
  take(std::move(*scan));
}

const SlamToolbox::Mount* SlamToolbox::mount_of(const LaserScan& message) {
  const std::string& frame = message.header.frame_id;
  const auto found = mounts_.find(frame);
  if (found != mounts_.end()) return &found->second;
  Mount mount;
  try {
    tf2::fromMsg(
        buffer_
            ->lookupTransform(parameters_.base_frame, frame, tf2_ros::fromMsg(message.header.stamp))
            .transform,
        mount.base_from_laser);
  } catch (const tf2::TransformException& error) {
    RCLCPP_ERROR(get_logger(), "Failed to compute laser pose, aborting initialization (%s)",
                 error.what());
    RCLCPP_WARN(get_logger(), "Failed to create laser device for %s; discarding scan",
                frame.c_str());
    return nullptr;
  }
  mount.max_range = parameters_.max_laser_range;
  if (mount.max_range <= 0.0) {
    RCLCPP_WARN(
        get_logger(),
        "You've set maximum_laser_range to be negative,this isn't allowed so it will be set "
        "to (%.1f).",
        message.range_max);
    mount.max_range = message.range_max;
  }
  if (mount.max_range > message.range_max) {
    RCLCPP_WARN(get_logger(),
                "maximum laser range setting (%.1f m) exceeds the capabilities of the used Lidar "
                "(%.1f m)",
                mount.max_range, message.range_max);
    mount.max_range = message.range_max;
  }
  return &mounts_.emplace(frame, mount).first->second;
}

std::optional<Scan> SlamToolbox::read(const LaserScan& message) {
  const Mount* const mount = mount_of(message);
  if (mount == nullptr) return std::nullopt;
  const tf2::Transform& base_from_laser = mount->base_from_laser;
  const auto in_base = [&base_from_laser](double range, double angle) {
    const tf2::Vector3 point =
        base_from_laser * tf2::Vector3(range * std::cos(angle), range * std::sin(angle), 0.0);
    return Point{point.x(), point.y()};
  };
  Scan scan;
  scan.time_ns = rclcpp::Time(message.header.stamp).nanoseconds();
  scan.sensor = {base_from_laser.getOrigin().x(), base_from_laser.getOrigin().y()};
  scan.rays = static_cast<uint32_t>(message.ranges.size());
  scan.max_range = mount->max_range;
  for (size_t i = 0; i < message.ranges.size(); ++i) {
    const double range = message.ranges[i];
    const double angle = message.angle_min + static_cast<double>(i) * message.angle_increment;
    // The comparison is false for what is not a number; a ray that met nothing says nothing.
    if (!(range > message.range_min && range < message.range_max)) continue;
    const Point hit = in_base(range, angle);
    if (std::isfinite(hit.x + hit.y)) scan.hits.push_back(hit);
  }
  find_middle(scan);
  return scan;
}

bool SlamToolbox::is_paused() const {
  return is_paused_ && start_ == Start::kOdometry && !mapper_->scans().empty();
}

bool SlamToolbox::should_process(const Scan& scan) {
  ++scan_count_;
  if (checked_odometry_) {
    if (is_paused_ || scan_count_ % parameters_.throttle_scans != 0) return false;
    const double interval = static_cast<double>(scan.time_ns - checked_ns_) / 1e9;
    if (interval < parameters_.minimum_time_interval || scan_count_ < 5) return false;
    // Odometry may say a little less than the mapper will.
    const MapperSettings& mapper = parameters_.mapper;
    const double moved = squared_distance(checked_odometry_->position(), scan.odometry.position());
    const double turned = std::abs(wrapped(scan.odometry.yaw - checked_odometry_->yaw));
    if (moved < 0.8 * mapper.minimum_travel_distance * mapper.minimum_travel_distance &&
        turned < mapper.minimum_travel_heading) {
      return false;
    }
  }
  checked_odometry_ = scan.odometry;
  checked_ns_ = scan.time_ns;
  return true;
}

void SlamToolbox::add(Scan scan) {
  const bool is_first = mapper_->scans().empty();
  std::optional<Eigen::Matrix3d> covariance;
  if (start_ == Start::kOdometry || is_first) {
    covariance = mapper_->process(std::move(scan));
  } else {
    scan.corrected = start_ == Start::kFirstScan ? mapper_->scans().front().corrected : start_pose_;
    covariance = mapper_->process_near(std::move(scan));
  }
  start_ = Start::kOdometry;
  if (!covariance) return;
  const Scan& added = mapper_->scans().back();
  map_from_odom_ = transform_of(added.corrected * inverse(added.odometry));
  publish_pose(added, *covariance);
  // The first map at once, so that others need not wait for it.
  if (is_first) publish_map();
}

void SlamToolbox::publish_pose(const Scan& scan, const Eigen::Matrix3d& covariance) {
  geometry_msgs::msg::PoseWithCovarianceStamped message;
  message.header.stamp = rclcpp::Time(scan.time_ns, RCL_ROS_TIME);
  message.header.frame_id = parameters_.map_frame;
  tf2::toMsg(transform_of(scan.corrected), message.pose.pose);
  auto& numbers = message.pose.covariance;
  const double scale = parameters_.position_covariance_scale;
  numbers[0] = covariance(0, 0) * scale;
  numbers[1] = numbers[6] = covariance(0, 1) * scale;
  numbers[7] = covariance(1, 1) * scale;
  numbers[35] = covariance(2, 2) * parameters_.yaw_covariance_scale;
  pose_publisher_->publish(message);
}

void SlamToolbox::publish_transform() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (!has_scan_) return;
  geometry_msgs::msg::TransformStamped message;
  message.transform = tf2::toMsg(map_from_odom_);
  message.header.frame_id = parameters_.map_frame;
  message.child_frame_id = parameters_.odom_frame;
  // Valid into the future, so that others can use the newest odometry.
  message.header.stamp =
      rclcpp::Time(scan_stamp_) + rclcpp::Duration::from_seconds(parameters_.transform_timeout);
  broadcaster_->sendTransform(message);
}

}  // namespace slam_toolbox
