// See amcl_node.hpp. What a scan changes, and what is published then.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "nav2_amcl/amcl_node.hpp"
#include "nav2_amcl/angleutils.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/string_utils.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace nav2_amcl {
namespace {

pf_vector_t pose_of(const tf2::Transform& transform) {
  return {
      {transform.getOrigin().x(), transform.getOrigin().y(), tf2::getYaw(transform.getRotation())}};
}

tf2::Quaternion around_z(double angle) {
  tf2::Quaternion rotation;
  rotation.setRPY(0, 0, angle);
  return rotation;
}

/// True while it exists.
class Working {
 public:
  explicit Working(bool& flag) : flag_(flag) { flag_ = true; }
  ~Working() { flag_ = false; }

 private:
  bool& flag_;
};

}  // namespace

void AmclNode::laserReceived(LaserScan::ConstSharedPtr laser_scan) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  scans_.push_back(laser_scan);
  // A lookup of transforms takes in new ones, which may let the next scan pass.
  if (is_working_) return;
  const Working working(is_working_);
  while (!scans_.empty()) {
    const LaserScan::ConstSharedPtr scan = scans_.front();
    scans_.pop_front();
    if (active_) handleScan(*scan);
  }
}

void AmclNode::handleScan(const LaserScan& scan) {
  if (map_ == nullptr) {
    if (mayRemind()) RCLCPP_WARN(get_logger(), "Waiting for map....");
    return;
  }
  Scanner* const scanner = scannerOf(scan);
  if (scanner == nullptr) return;
  tf2::Transform odom_to_base;
  if (!getOdomPose(scan, odom_to_base)) {
    RCLCPP_ERROR(get_logger(), "Couldn't determine robot's pose associated with laser scan");
    return;
  }
  const pf_vector_t pose = pose_of(odom_to_base);
  const bool is_first = !has_odom_pose_;
  if (is_first) {
    odom_pose_ = pose;
    has_odom_pose_ = true;
    resample_count_ = 0;
  }
  pf_vector_t delta = pf_vector_sub(pose, odom_pose_);
  delta.v[2] = angleutils::angle_diff(pose.v[2], odom_pose_.v[2]);
  if (is_first || shouldUpdateFilter(delta)) {
    for (auto& [frame, each] : scanners_) each.needs_update = true;
  }
  bool is_resampled = false;
  const std::optional<LaserData> data = scanner->needs_update ? readScan(scan) : std::nullopt;
  if (data) {
    if (!is_first) {
      filter_->move(*motion_model_, pose, delta);
      force_update_ = false;
    }
    filter_->measure([scanner, &data](Particles& particles, bool is_converged) {
      return scanner->model->weigh(*data, particles, is_converged);
    });
    scanner->needs_update = false;
    odom_pose_ = pose;
    if (++resample_count_ % parameters_.resample_interval == 0) {
      filter_->resample(randomPoses());
      is_resampled = true;
    }
    RCLCPP_DEBUG(get_logger(), "Num samples: %d\n", static_cast<int>(filter_->particles().size()));
    publishParticleCloud();
  }
  if (is_resampled || is_first || !first_pose_sent_) {
    publishEstimate(scan, odom_to_base);
  } else {
    sendMapToOdomTransform(scan);
  }
}

AmclNode::Scanner* AmclNode::scannerOf(const LaserScan& scan) {
  const std::string frame = nav2_util::strip_leading_slash(scan.header.frame_id);
  const auto found = scanners_.find(frame);
  if (found != scanners_.end()) return &found->second;
  std::unique_ptr<LaserModel> model = makeLaserModel(frame);
  if (model == nullptr) return nullptr;
  Scanner& added = scanners_[frame];
  added.model = std::move(model);
  return &added;
}

std::unique_ptr<LaserModel> AmclNode::makeLaserModel(const std::string& laser_frame) {
  RCLCPP_INFO(get_logger(), "createLaserObject");
  try {
    const auto mount =
        tf_buffer_->lookupTransform(parameters_.base_frame_id, laser_frame, tf2::TimePointZero,
                                    tf2::durationFromSec(parameters_.transform_tolerance));
    // Bearings are turned into the frame of the robot, so the laser has no yaw.
    const pf_vector_t pose{{mount.transform.translation.x, mount.transform.translation.y, 0.0}};
    return make_laser_model(parameters_.laser_model_type, parameters_.laser, map_, pose);
  } catch (const tf2::TransformException& error) {
    RCLCPP_ERROR(get_logger(),
                 "Couldn't transform from %s to %s, even though the message notifier is in use: "
                 "(%s)",
                 laser_frame.c_str(), parameters_.base_frame_id.c_str(), error.what());
    return nullptr;
  }
}

bool AmclNode::getOdomPose(const LaserScan& scan, tf2::Transform& odom_to_base) {
  try {
    tf2::fromMsg(tf_buffer_
                     ->lookupTransform(parameters_.odom_frame_id, parameters_.base_frame_id,
                                       tf2_ros::fromMsg(scan.header.stamp))
                     .transform,
                 odom_to_base);
  } catch (const tf2::TransformException& error) {
    if (++scan_error_count_ % 20 == 0) {
      RCLCPP_ERROR(get_logger(), "(%d) consecutive laser scan transforms failed: (%s)",
                   scan_error_count_, error.what());
    }
    return false;
  }
  scan_error_count_ = 0;
  return true;
}

bool AmclNode::shouldUpdateFilter(const pf_vector_t& delta) const {
  return std::abs(delta.v[0]) > parameters_.update_min_d ||
         std::abs(delta.v[1]) > parameters_.update_min_d ||
         std::abs(delta.v[2]) > parameters_.update_min_a || force_update_;
}

std::optional<LaserData> AmclNode::readScan(const LaserScan& scan) {
  tf2::Quaternion mount;
  try {
    tf2::fromMsg(tf_buffer_
                     ->lookupTransform(parameters_.base_frame_id,
                                       nav2_util::strip_leading_slash(scan.header.frame_id),
                                       tf2_ros::fromMsg(scan.header.stamp))
                     .transform.rotation,
                 mount);
  } catch (const tf2::TransformException& error) {
    RCLCPP_WARN(get_logger(), "Unable to transform min/max laser angles into base frame: %s",
                error.what());
    return std::nullopt;
  }
  if (!(scan.range_max > 0.0F)) {
    RCLCPP_WARN(get_logger(),
                "wrong range_max of laser_scan data: %f. The message could be malformed."
                " Ignore this message and stop updating.",
                scan.range_max);
    return std::nullopt;
  }
  // A laser that is mounted upside down turns the other way.
  const double first = tf2::getYaw(mount * around_z(scan.angle_min));
  const double second =
      tf2::getYaw(mount * around_z(static_cast<double>(scan.angle_min) + scan.angle_increment));
  const double step = angleutils::angle_diff(second, first);
  const double most = parameters_.laser_max_range;
  const double least = parameters_.laser_min_range;
  const double range_max = scan.range_max;
  const double range_min = scan.range_min;
  const double shortest = least > 0.0 ? std::max(range_min, least) : range_min;
  LaserData data;
  data.range_max = most > 0.0 ? std::min(range_max, most) : range_max;
  data.beams.reserve(scan.ranges.size());
  for (size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    data.beams.push_back(
        {range <= shortest ? data.range_max : range, first + static_cast<double>(i) * step});
  }
  return data;
}

void AmclNode::publishParticleCloud() {
  if (!initial_pose_is_known_) return;
  auto cloud = std::make_unique<nav2_msgs::msg::ParticleCloud>();
  cloud->header.stamp = now();
  cloud->header.frame_id = parameters_.global_frame_id;
  cloud->particles.reserve(filter_->particles().size());
  for (const pf_sample_t& particle : filter_->particles()) {
    auto& message = cloud->particles.emplace_back();
    message.pose.position.x = particle.pose.v[0];
    message.pose.position.y = particle.pose.v[1];
    message.pose.orientation =
        nav2_util::geometry_utils::orientationAroundZAxis(particle.pose.v[2]);
    message.weight = particle.weight;
  }
  particle_cloud_pub_->publish(std::move(cloud));
}

void AmclNode::publishEstimate(const LaserScan& scan, const tf2::Transform& odom_to_base) {
  const PoseEstimate* const best = filter_->best_cluster();
  if (best == nullptr || !(best->weight > 0.0)) {
    RCLCPP_ERROR(get_logger(), "No pose!");
    return;
  }
  RCLCPP_DEBUG(get_logger(), "Max weight pose: %.3f %.3f %.3f", best->mean.v[0], best->mean.v[1],
               best->mean.v[2]);
  if (!initial_pose_is_known_) {
    if (mayRemind()) {
      RCLCPP_WARN(get_logger(),
                  "AMCL cannot publish a pose or update the transform. Please set the initial "
                  "pose...");
    }
    return;
  }
  if (!publishAmclPose(scan, *best)) return;
  const tf2::Transform map_to_base(around_z(best->mean.v[2]),
                                   tf2::Vector3(best->mean.v[0], best->mean.v[1], 0.0));
  map_to_odom_ = map_to_base * odom_to_base.inverse();
  sendMapToOdomTransform(scan);
}

bool AmclNode::publishAmclPose(const LaserScan& scan, const PoseEstimate& best) {
  auto message = std::make_unique<PoseWithCovariance>();
  message->header.frame_id = parameters_.global_frame_id;
  message->header.stamp = scan.header.stamp;
  auto& [pose, covariance] = message->pose;
  pose.position.x = best.mean.v[0];
  pose.position.y = best.mean.v[1];
  pose.orientation = nav2_util::geometry_utils::orientationAroundZAxis(best.mean.v[2]);
  const pf_matrix_t& spread = filter_->whole().covariance;
  for (size_t i = 0; i < 2; ++i) {
    for (size_t j = 0; j < 2; ++j) covariance[6 * i + j] = spread.m[i][j];
  }
  covariance[35] = spread.m[2][2];
  const double sum = std::accumulate(covariance.begin(), covariance.end(), 0.0);
  if (std::isnan(sum + pose.position.x + pose.position.y)) {
    RCLCPP_WARN(get_logger(),
                "AMCL covariance or pose is NaN, likely due to an invalid configuration or faulty "
                "sensor measurements! Pose is not available!");
    return false;
  }
  RCLCPP_DEBUG(get_logger(), "Publishing pose");
  last_published_pose_ = *message;
  first_pose_sent_ = true;
  pose_pub_->publish(std::move(message));
  return true;
}

void AmclNode::sendMapToOdomTransform(const LaserScan& scan) {
  if (!parameters_.tf_broadcast || !initial_pose_is_known_ || !map_to_odom_) return;
  geometry_msgs::msg::TransformStamped message;
  message.header.frame_id = parameters_.global_frame_id;
  // Valid into the future, so that others can use the newest odometry.
  message.header.stamp = tf2_ros::toMsg(tf2_ros::fromMsg(scan.header.stamp) +
                                        tf2::durationFromSec(parameters_.transform_tolerance));
  message.child_frame_id = parameters_.odom_frame_id;
  message.transform = tf2::toMsg(*map_to_odom_);
  tf_broadcaster_->sendTransform(message);
  sent_first_transform_ = true;
}

}  // namespace nav2_amcl
