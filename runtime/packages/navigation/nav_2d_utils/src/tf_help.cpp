// See tf_help.hpp.
#include "nav_2d_utils/tf_help.hpp"

namespace nav_2d_utils {

namespace {

rclcpp::Logger logger() {
  return rclcpp::get_logger("tf_help");
}

/// With the newest transform. Throws tf2::TransformException.
bool transform_with_newest(const tf2_ros::Buffer& tf, const std::string& frame,
                           const geometry_msgs::msg::PoseStamped& in_pose,
                           geometry_msgs::msg::PoseStamped& out_pose,
                           const rclcpp::Duration& tolerance) {
  const auto transform = tf.lookupTransform(frame, in_pose.header.frame_id, tf2::TimePointZero);
  const builtin_interfaces::msg::Time& data = in_pose.header.stamp;
  const builtin_interfaces::msg::Time& newest = transform.header.stamp;
  if (rclcpp::Time(data) - rclcpp::Time(newest) <= tolerance) {
    tf2::doTransform(in_pose, out_pose, transform);
    return true;
  }
  RCLCPP_ERROR(logger(), "Transform data too old when converting from %s to %s",
               in_pose.header.frame_id.c_str(), frame.c_str());
  RCLCPP_ERROR(logger(), "Data time: %ds %uns, Transform time: %ds %uns", data.sec, data.nanosec,
               newest.sec, newest.nanosec);
  return false;
}

}  // namespace

bool transformPose(const std::shared_ptr<tf2_ros::Buffer> tf, const std::string frame,
                   const geometry_msgs::msg::PoseStamped& in_pose,
                   geometry_msgs::msg::PoseStamped& out_pose,
                   rclcpp::Duration& transform_tolerance) {
  if (in_pose.header.frame_id == frame) {
    out_pose = in_pose;
    return true;
  }
  try {
    try {
      tf->transform(in_pose, out_pose, frame);
      return true;
    } catch (const tf2::ExtrapolationException&) {
      return transform_with_newest(*tf, frame, in_pose, out_pose, transform_tolerance);
    }
  } catch (const tf2::TransformException& error) {
    RCLCPP_ERROR(logger(), "Exception in transformPose: %s", error.what());
    return false;
  }
}

bool transformPose(const std::shared_ptr<tf2_ros::Buffer> tf, const std::string frame,
                   const nav_2d_msgs::msg::Pose2DStamped& in_pose,
                   nav_2d_msgs::msg::Pose2DStamped& out_pose,
                   rclcpp::Duration& transform_tolerance) {
  geometry_msgs::msg::PoseStamped result;
  if (!transformPose(tf, frame, pose2DToPoseStamped(in_pose), result, transform_tolerance)) {
    return false;
  }
  out_pose = poseStampedToPose2D(result);
  return true;
}

}  // namespace nav_2d_utils
