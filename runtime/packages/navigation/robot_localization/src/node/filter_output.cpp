// See filter_node.hpp: what happens every period.
#include <cmath>
#include <utility>

#include "node/filter_node.hpp"

namespace robot_localization {
namespace {

bool is_finite(const nav_msgs::msg::Odometry& message) {
  const auto& position = message.pose.pose.position;
  const auto& rotation = message.pose.pose.orientation;
  const auto& linear = message.twist.twist.linear;
  const auto& angular = message.twist.twist.angular;
  // A sum is finite only when its parts are.
  return std::isfinite(position.x + position.y + position.z + rotation.x + rotation.y + rotation.z +
                       rotation.w + linear.x + linear.y + linear.z + angular.x + angular.y +
                       angular.z);
}

template <typename Block, typename Array>
void copy_block(const Block& from, Array& to) {
  Matrix6::Map(to.data()) = from;
}

}  // namespace

rclcpp::Time FilterNode::filter_time() const {
  return rclcpp::Time(state().time_ns, RCL_ROS_TIME);
}

void FilterNode::update() {
  reset_after_jump();
  if (!is_enabled_) {
    RCLCPP_INFO_ONCE(get_logger(), "Filter is disabled. To enable it call the %s service",
                     enable_service_->get_service_name());
    return;
  }
  const rclcpp::Time began_at = now();
  if (is_processing_) {
    estimator_.integrate(began_at.nanoseconds());
    differentiate(began_at);
  } else {
    estimator_.clear_queue();
    if (state().is_initialized) estimator_.filter().set_time(began_at.nanoseconds());
  }
  if (state().is_initialized && publish_odometry() && acceleration_publisher_) {
    publish_acceleration();
  }
  const double took = (now() - began_at).seconds();
  if (took > 1.0 / parameters_.frequency) {
    RCLCPP_ERROR(get_logger(),
                 "Failed to meet update rate! Took %.20gseconds. Try decreasing the rate, limiting "
                 "sensor output frequency, or limiting the number of sensors.",
                 took);
  }
}

void FilterNode::differentiate(const rclcpp::Time& now) {
  if (!state().is_initialized) return;
  const Eigen::Vector3d velocity = state().mean.segment<3>(kVroll);
  const double dt =
      static_cast<double>(now.nanoseconds() - differentiated_at_.nanoseconds()) * 1e-9;
  if (dt > 0.0) {
    turning_.acceleration = (velocity - turning_.velocity) / dt;
    turning_covariance_ = state().covariance.block<3, 3>(kVroll, kVroll) * (2.0 / (dt * dt));
  }
  turning_.velocity = velocity;
  differentiated_at_ = now;
}

nav_msgs::msg::Odometry FilterNode::odometry() const {
  const State& mean = state().mean;
  nav_msgs::msg::Odometry message;
  message.header.stamp = filter_time();
  message.header.frame_id = parameters_.world_frame;
  message.child_frame_id = parameters_.base_link_frame_output;
  message.pose.pose.position.x = mean(kX);
  message.pose.pose.position.y = mean(kY);
  message.pose.pose.position.z = mean(kZ);
  message.pose.pose.orientation = to_message(quaternion_of(mean(kRoll), mean(kPitch), mean(kYaw)));
  message.twist.twist.linear.x = mean(kVx);
  message.twist.twist.linear.y = mean(kVy);
  message.twist.twist.linear.z = mean(kVz);
  message.twist.twist.angular.x = mean(kVroll);
  message.twist.twist.angular.y = mean(kVpitch);
  message.twist.twist.angular.z = mean(kVyaw);
  copy_block(state().covariance.block<6, 6>(kX, kX), message.pose.covariance);
  copy_block(state().covariance.block<6, 6>(kVx, kVx), message.twist.covariance);
  return message;
}

bool FilterNode::publish_odometry() {
  const nav_msgs::msg::Odometry message = odometry();
  if (!is_finite(message)) {
    RCLCPP_ERROR(get_logger(),
                 "Critical Error, NaNs were detected in the output state of the filter. This was "
                 "likely due to poorly coniditioned process, noise, or sensor covariances.");
  }
  // A late measurement changes an estimate that was published; tf2 warns of a stamp that it has.
  const bool is_again =
      !parameters_.permits_corrected_publication && newest_published_ns_ >= state().time_ns;
  newest_published_ns_ = state().time_ns;
  frequency_task_->tick();
  if (is_again) return false;
  if (parameters_.publishes_tf) publish_transform(message);
  odometry_publisher_->publish(message);
  return true;
}

void FilterNode::publish_transform(const nav_msgs::msg::Odometry& odometry) {
  geometry_msgs::msg::TransformStamped message;
  message.header.frame_id = odometry.header.frame_id;
  message.header.stamp =
      filter_time() + rclcpp::Duration::from_seconds(parameters_.transform_time_offset);
  message.child_frame_id = odometry.child_frame_id;
  Eigen::Isometry3d world_from_base = Eigen::Isometry3d::Identity();
  world_from_base.translation() = state().mean.segment<3>(kX);
  world_from_base.linear() =
      quaternion_of(state().mean(kRoll), state().mean(kPitch), state().mean(kYaw))
          .toRotationMatrix();
  message.transform = to_message(world_from_base);
  if (odometry.header.frame_id == parameters_.odom_frame) {
    broadcaster_->sendTransform(message);
  } else if (odometry.header.frame_id == parameters_.map_frame) {
    // Another node says where the base is in the odom frame; the rest is ours.
    const auto base_from_odom =
        transforms_.latest(parameters_.base_link_frame, parameters_.odom_frame);
    if (!base_from_odom) {
      RCLCPP_ERROR_SKIPFIRST_THROTTLE(
          get_logger(), *get_clock(), 5000, "Could not obtain transform from %s->%s",
          parameters_.odom_frame.c_str(), parameters_.base_link_frame.c_str());
      return;
    }
    message.child_frame_id = parameters_.odom_frame;
    message.transform = to_message(world_from_base * *base_from_odom);
    broadcaster_->sendTransform(message);
  } else {
    RCLCPP_ERROR(get_logger(), "Odometry message frame_id was %s, expected %s or %s",
                 odometry.header.frame_id.c_str(), parameters_.map_frame.c_str(),
                 parameters_.odom_frame.c_str());
  }
}

void FilterNode::publish_acceleration() {
  geometry_msgs::msg::AccelWithCovarianceStamped message;
  message.header.stamp = filter_time();
  message.header.frame_id = parameters_.base_link_frame_output;
  message.accel.accel.linear.x = state().mean(kAx);
  message.accel.accel.linear.y = state().mean(kAy);
  message.accel.accel.linear.z = state().mean(kAz);
  message.accel.accel.angular.x = turning_.acceleration.x();
  message.accel.accel.angular.y = turning_.acceleration.y();
  message.accel.accel.angular.z = turning_.acceleration.z();
  Matrix6 covariance = Matrix6::Zero();
  covariance.topLeftCorner<3, 3>() = state().covariance.block<3, 3>(kAx, kAx);
  covariance.bottomRightCorner<3, 3>() = turning_covariance_;
  copy_block(covariance, message.accel.covariance);
  acceleration_publisher_->publish(message);
}

}  // namespace robot_localization
