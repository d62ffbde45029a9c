// See robot_utils.hpp.
#include "nav2_util/robot_utils.hpp"

#include <cmath>

#include "tf2/convert.h"

namespace nav2_util {
namespace {

bool is_finite(const geometry_msgs::msg::Vector3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

void say_missing(const std::string& source, const std::string& target,
                 const tf2::TransformException& error) {
  RCLCPP_ERROR(rclcpp::get_logger("getTransform"),
               "Failed to get \"%s\"->\"%s\" frame transform: %s", source.c_str(), target.c_str(),
               error.what());
}

}  // namespace

bool getCurrentPose(geometry_msgs::msg::PoseStamped& global_pose, tf2_ros::Buffer& tf_buffer,
                    const std::string global_frame, const std::string robot_frame,
                    const double transform_timeout, const rclcpp::Time stamp) {
  global_pose = geometry_msgs::msg::PoseStamped();
  global_pose.header.frame_id = robot_frame;
  global_pose.header.stamp = stamp;
  return transformPoseInTargetFrame(global_pose, global_pose, tf_buffer, global_frame,
                                    transform_timeout);
}

bool transformPoseInTargetFrame(const geometry_msgs::msg::PoseStamped& input_pose,
                                geometry_msgs::msg::PoseStamped& transformed_pose,
                                tf2_ros::Buffer& tf_buffer, const std::string target_frame,
                                const double transform_timeout) {
  const rclcpp::Logger logger = rclcpp::get_logger("transformPoseInTargetFrame");
  try {
    transformed_pose =
        tf_buffer.transform(input_pose, target_frame, tf2::durationFromSec(transform_timeout));
    return true;
  } catch (const tf2::LookupException& error) {
    RCLCPP_ERROR(logger, "No Transform available Error looking up target frame: %s\n",
                 error.what());
  } catch (const tf2::ConnectivityException& error) {
    RCLCPP_ERROR(logger, "Connectivity Error looking up target frame: %s\n", error.what());
  } catch (const tf2::ExtrapolationException& error) {
    RCLCPP_ERROR(logger, "Extrapolation Error looking up target frame: %s\n", error.what());
  } catch (const tf2::TimeoutException&) {
    RCLCPP_ERROR(logger, "Transform timeout with tolerance: %.4f", transform_timeout);
  } catch (const tf2::TransformException&) {
    RCLCPP_ERROR(logger, "Failed to transform from %s to %s", input_pose.header.frame_id.c_str(),
                 target_frame.c_str());
  }
  return false;
}

bool getTransform(const std::string& source_frame_id, const std::string& target_frame_id,
                  const tf2::Duration& transform_tolerance,
                  const std::shared_ptr<tf2_ros::Buffer> tf_buffer,
                  geometry_msgs::msg::TransformStamped& transform_msg) {
  if (source_frame_id == target_frame_id) return true;
  try {
    transform_msg = tf_buffer->lookupTransform(target_frame_id, source_frame_id, tf2::TimePointZero,
                                               transform_tolerance);
  } catch (const tf2::TransformException& error) {
    say_missing(source_frame_id, target_frame_id, error);
    return false;
  }
  return true;
}

bool getTransform(const std::string& source_frame_id, const std::string& target_frame_id,
                  const tf2::Duration& transform_tolerance,
                  const std::shared_ptr<tf2_ros::Buffer> tf_buffer, tf2::Transform& tf2_transform) {
  tf2_transform.setIdentity();
  geometry_msgs::msg::TransformStamped message;
  if (!getTransform(source_frame_id, target_frame_id, transform_tolerance, tf_buffer, message)) {
    return false;
  }
  tf2::fromMsg(message.transform, tf2_transform);
  return true;
}

bool getTransform(const std::string& source_frame_id, const rclcpp::Time& source_time,
                  const std::string& target_frame_id, const rclcpp::Time& target_time,
                  const std::string& fixed_frame_id, const tf2::Duration& transform_tolerance,
                  const std::shared_ptr<tf2_ros::Buffer> tf_buffer,
                  geometry_msgs::msg::TransformStamped& transform_msg) {
  try {
    transform_msg = tf_buffer->lookupTransform(target_frame_id, target_time, source_frame_id,
                                               source_time, fixed_frame_id, transform_tolerance);
  } catch (const tf2::TransformException& error) {
    say_missing(source_frame_id, target_frame_id, error);
    return false;
  }
  return true;
}

bool getTransform(const std::string& source_frame_id, const rclcpp::Time& source_time,
                  const std::string& target_frame_id, const rclcpp::Time& target_time,
                  const std::string& fixed_frame_id, const tf2::Duration& transform_tolerance,
                  const std::shared_ptr<tf2_ros::Buffer> tf_buffer, tf2::Transform& tf2_transform) {
  tf2_transform.setIdentity();
  geometry_msgs::msg::TransformStamped message;
  if (!getTransform(source_frame_id, source_time, target_frame_id, target_time, fixed_frame_id,
                    transform_tolerance, tf_buffer, message)) {
    return false;
  }
  tf2::fromMsg(message.transform, tf2_transform);
  return true;
}

bool validateTwist(const geometry_msgs::msg::Twist& msg) {
  return is_finite(msg.linear) && is_finite(msg.angular);
}

bool validateTwist(const geometry_msgs::msg::TwistStamped& msg) {
  return validateTwist(msg.twist);
}

}  // namespace nav2_util
