// The odometry of drives of Gazebo Sim: two topics, their frames and their rate.
#pragma once

#include <nav_msgs/msg/odometry.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "plugins/gz_topics.hpp"
#include "plugins/messages.hpp"

namespace ros2wasm_sim {

class GzOdometry {
 public:
  GzOdometry(const PluginContext& context, const Parameters& given)
      : rate_(given.number("odom_publish_frequency", 50)) {
    const Model& model = *context.model;
    const std::string canonical =
        model.canonical_link.empty() ? model.links.front().name : model.canonical_link;
    frame_ = given.text("frame_id", model.name + "/odom");
    child_frame_ = given.text("child_frame_id", model.name + "/" + canonical);
    const std::string prefix = "/model/" + model.name;
    odometry_ = publish_gz<nav_msgs::msg::Odometry>(
        context.host, topic_of(given, "odom_topic", prefix + "/odometry"));
    frames_ = publish_gz<tf2_msgs::msg::TFMessage>(context.host,
                                                   topic_of(given, "tf_topic", prefix + "/tf"));
  }

  /// `linear` and `turn` are in the frame of the robot.
  void publish(const Now& now, const Pose& pose, const Vector3& linear, double turn) {
    if (!rate_.due(now.time_ns)) return;
    nav_msgs::msg::Odometry message;
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    message.child_frame_id = child_frame_;
    message.pose.pose = pose_message(pose);
    message.twist.twist.linear = vector_message(linear);
    message.twist.twist.angular.z = turn;
    odometry_->publish(message);
    tf2_msgs::msg::TFMessage frames;
    frames.transforms.push_back(
        transform_message(message.header.stamp, frame_, child_frame_, pose));
    frames_->publish(frames);
  }

  void reset() { rate_.reset(); }

 private:
  Rate rate_;
  std::string frame_, child_frame_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr frames_;
};

}  // namespace ros2wasm_sim
