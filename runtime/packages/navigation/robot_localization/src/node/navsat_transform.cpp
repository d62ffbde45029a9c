// See navsat_transform.hpp: what messages do.
#include "node/navsat_transform.hpp"

#include <cmath>

#include "filter/readings.hpp"
#include "geo/world_frame.hpp"

namespace robot_localization {

void NavSatTransform::on_odometry(const Odometry& message) {
  world_frame_ = message.header.frame_id;
  base_link_frame_ = message.child_frame_id;
  Pose pose{Eigen::Isometry3d::Identity(), Eigen::Matrix3d::Zero(), message.header.stamp};
  pose.pose.translation() = vector_of(message.pose.pose.position);
  pose.pose.linear() = rotation_of(message.pose.pose.orientation)
                           .value_or(Eigen::Quaterniond::Identity())
                           .toRotationMatrix();
  pose.covariance = Matrix6::Map(message.pose.covariance.data()).topLeftCorner<3, 3>();
  pose_ = pose;
  if (world_from_cartesian_) return;
  first_pose_ = pose.pose;
  if (uses_odometry_yaw_ && !datum_) {
    take_orientation(message.pose.pose.orientation, base_link_frame_, message.header.stamp);
  }
}

void NavSatTransform::on_imu(const Imu& message) {
  // The odometry says which frame the robot has.
  if (first_pose_) {
    take_orientation(message.orientation, message.header.frame_id, message.header.stamp);
  }
}

void NavSatTransform::take_orientation(const geometry_msgs::msg::Quaternion& orientation,
                                       const std::string& frame, const rclcpp::Time& stamp) {
  const auto rotation = rotation_of(orientation);
  const auto mounting = transforms_.lookup(base_link_frame_, frame, stamp, transform_timeout_);
  if (!rotation || !mounting) return;
  orientation_ =
      Eigen::Quaterniond(without_mounting(rotation->toRotationMatrix(), mounting->linear()));
}

void NavSatTransform::on_fix(const Fix& message) {
  antenna_frame_ = message.header.frame_id;
  if (antenna_frame_.empty()) {
    RCLCPP_ERROR_THROTTLE(get_logger(), *get_clock(), 5000,
                          "NavSatFix message has empty frame_id. Will assume navsat device is "
                          "mounted at robot's origin");
  }
  const GeoPoint place{message.latitude, message.longitude, message.altitude};
  if (message.status.status == sensor_msgs::msg::NavSatStatus::STATUS_NO_FIX ||
      !std::isfinite(place.latitude + place.longitude + place.altitude)) {
    return;
  }
  if (!world_from_cartesian_ && !datum_) {
    const auto point = cartesian_->set_datum(place);
    if (const auto* error = std::get_if<std::string>(&point)) {
      RCLCPP_ERROR(get_logger(), "%s", error->c_str());
      return;
    }
    first_position_ = std::get<Eigen::Vector3d>(point);
  }
  const auto point = cartesian_->from_geo(place);
  if (!std::holds_alternative<Eigen::Vector3d>(point)) return;
  position_ =
      Position{std::get<Eigen::Vector3d>(point),
               Eigen::Matrix3d::Map(message.position_covariance.data()), message.header.stamp};
}

void NavSatTransform::update() {
  if (!world_from_cartesian_) {
    compute_transform();
    return;
  }
  publish_gps_odometry();
  if (fix_publisher_) publish_filtered_gps();
}

/// The world frame begins at the datum.
void NavSatTransform::take_manual_datum() {
  const auto point = cartesian_->set_datum(datum_->place);
  if (const auto* error = std::get_if<std::string>(&point)) {
    RCLCPP_ERROR_THROTTLE(get_logger(), *get_clock(), 5000, "%s", error->c_str());
    return;
  }
  first_position_ = std::get<Eigen::Vector3d>(point);
  first_pose_ = Eigen::Isometry3d::Identity();
  orientation_ = datum_->orientation;
  position_.reset();  // it may be of another zone
}

void NavSatTransform::compute_transform() {
  if (datum_ && first_pose_) take_manual_datum();
  if (!first_pose_ || !first_position_ || !orientation_) return;
  const double convergence = cartesian_->meridian_convergence();
  const double heading = roll_pitch_yaw(orientation_->toRotationMatrix()).z() +
                         magnetic_declination_ + yaw_offset_ + convergence;
  const Eigen::Vector3d robot =
      datum_ ? *first_position_ : robot_in_cartesian(*first_position_, heading);
  const auto datum = datum_ ? std::optional(datum_->place) : cartesian_->to_geo(*first_position_);
  if (datum) {
    RCLCPP_INFO(get_logger(), "Datum (latitude, longitude, altitude) is (%0.2f, %0.2f, %0.2f)",
                datum->latitude, datum->longitude, datum->altitude);
  }
  RCLCPP_INFO(get_logger(), "Datum %s coordinate is (%d %s, %0.2f, %0.2f)",
              cartesian_->is_local() ? "Local Cartesian" : "UTM", cartesian_->zone(),
              cartesian_->is_north() ? "north" : "south", first_position_->x(),
              first_position_->y());
  RCLCPP_INFO(get_logger(),
              "Corrected for magnetic declination of %g, user-specified offset of %g and meridian "
              "convergence of %g. Transform heading factor is now %g",
              magnetic_declination_, yaw_offset_, convergence, heading);
  world_from_cartesian_ = world_from_cartesian(*first_pose_, robot, heading);
  imu_subscription_.reset();
  if (broadcasts_) broadcast_transform();
}

Eigen::Vector3d NavSatTransform::robot_in_cartesian(const Eigen::Vector3d& antenna,
                                                    double heading) const {
  const auto offset = transforms_.latest(base_link_frame_, antenna_frame_);
  if (!offset) {
    if (!antenna_frame_.empty()) {
      RCLCPP_ERROR(get_logger(),
                   "Unable to obtain %s -> %s transform. Will assume navsat device is mounted at "
                   "robots origin",
                   base_link_frame_.c_str(), antenna_frame_.c_str());
    }
    return antenna;
  }
  const Eigen::Vector3d angles = roll_pitch_yaw(orientation_->toRotationMatrix());
  return antenna - quaternion_of(angles.x(), angles.y(), heading) * offset->translation();
}

Eigen::Vector3d NavSatTransform::robot_in_world(const Eigen::Vector3d& antenna,
                                                const rclcpp::Time& stamp) {
  const auto offset =
      transforms_.lookup(base_link_frame_, antenna_frame_, stamp, transform_timeout_);
  const auto robot =
      offset ? transforms_.lookup(world_frame_, base_link_frame_, stamp, transform_timeout_)
             : std::nullopt;
  if (robot) return antenna - robot->linear() * offset->translation();
  const std::string& from = offset ? world_frame_ : base_link_frame_;
  const std::string& to = offset ? base_link_frame_ : antenna_frame_;
  RCLCPP_ERROR_THROTTLE(get_logger(), *get_clock(), 5000,
                        "Could not obtain %s -> %s transform. Will not remove offset of navsat "
                        "device from robot's origin.",
                        from.c_str(), to.c_str());
  return antenna;
}

void NavSatTransform::broadcast_transform() {
  const std::string cartesian_frame = cartesian_->is_local() ? "local_enu" : "utm";
  geometry_msgs::msg::TransformStamped message;
  message.header.stamp = now();
  message.header.frame_id = broadcasts_as_parent_ ? cartesian_frame : world_frame_;
  message.child_frame_id = broadcasts_as_parent_ ? world_frame_ : cartesian_frame;
  message.transform =
      to_message(broadcasts_as_parent_ ? world_from_cartesian_->inverse() : *world_from_cartesian_);
  message.transform.translation.z = flattened(message.transform.translation.z);
  broadcaster_.sendTransform(message);
}

void NavSatTransform::publish_gps_odometry() {
  if (!position_ || position_->is_published || !pose_) return;
  position_->is_published = true;
  Odometry message;
  message.header.frame_id = world_frame_;
  message.header.stamp = position_->stamp;
  Eigen::Vector3d antenna = *world_from_cartesian_ * position_->point;
  antenna.z() = flattened(antenna.z());
  const Eigen::Vector3d robot = robot_in_world(antenna, position_->stamp);
  message.pose.pose.position.x = robot.x();
  message.pose.pose.position.y = robot.y();
  message.pose.pose.position.z = flattened(robot.z());
  const Eigen::Matrix3d rotation = world_from_cartesian_->linear();
  Matrix6 covariance = Matrix6::Zero();
  covariance.topLeftCorner<3, 3>() = rotation * position_->covariance * rotation.transpose();
  Matrix6::Map(message.pose.covariance.data()) = covariance;
  odometry_publisher_->publish(message);
}

void NavSatTransform::publish_filtered_gps() {
  if (!pose_ || pose_->is_published) return;
  const auto place = to_geo(pose_->pose.translation());
  if (!place) return;
  pose_->is_published = true;
  Fix message;
  message.header.frame_id = base_link_frame_;
  message.header.stamp = pose_->stamp;
  message.latitude = place->latitude;
  message.longitude = place->longitude;
  message.altitude = place->altitude;
  message.status.status = sensor_msgs::msg::NavSatStatus::STATUS_GBAS_FIX;
  const Eigen::Matrix3d rotation = world_from_cartesian_->linear().transpose();
  Eigen::Matrix3d::Map(message.position_covariance.data()) =
      rotation * pose_->covariance * rotation.transpose();
  message.position_covariance_type = Fix::COVARIANCE_TYPE_KNOWN;
  fix_publisher_->publish(message);
}

std::optional<GeoPoint> NavSatTransform::to_geo(const Eigen::Vector3d& world_point) const {
  if (!world_from_cartesian_) return std::nullopt;
  return cartesian_->to_geo(world_from_cartesian_->inverse() * world_point);
}

std::optional<Eigen::Vector3d> NavSatTransform::from_geo(const GeoPoint& place) const {
  if (!world_from_cartesian_) return std::nullopt;
  const auto point = cartesian_->from_geo(place);
  const auto* found = std::get_if<Eigen::Vector3d>(&point);
  if (!found) return std::nullopt;
  Eigen::Vector3d result = *world_from_cartesian_ * *found;
  result.z() = flattened(result.z());
  return result;
}

}  // namespace robot_localization
