// Odometry as the drives of Gazebo Classic publish it.
#pragma once

#include <nav_msgs/msg/odometry.hpp>

#include <string>

#include "plugins/messages.hpp"
#include "plugins/plugin.hpp"

namespace ros2wasm_sim {

/// Along the axes of the body, which is level: forward, to the left, and turning (m/s, rad/s).
struct LevelMotion {
  Vector3 linear;
  double turning = 0;
};

/// The true motion of a model, by its canonical link.
inline LevelMotion level_motion(Simulation& simulation, const Model& model, const Pose& pose) {
  const std::string& link =
      model.canonical_link.empty() ? model.links.front().name : model.canonical_link;
  Physics& physics = simulation.physics();
  const Motion motion = physics.velocity(physics.link(model.name, link));
  Vector3 linear = rotate(from_roll_pitch_yaw(0, 0, -yaw_of(pose.orientation)), motion.linear);
  linear.z = 0;
  return {linear, motion.angular.z};
}

class ClassicOdometry {
 public:
  explicit ClassicOdometry(const Parameters& given)
      : frame_(given.text("odometry_frame", "odom")),
        base_(given.text("robot_base_frame", "base_footprint")),
        covariance_{given.number("covariance_x", 1e-5), given.number("covariance_y", 1e-5),
                    given.number("covariance_yaw", 1e-3)} {}

  const std::string& frame() const { return frame_; }
  const std::string& base() const { return base_; }

  /// The covariances of the twist are 0.
  nav_msgs::msg::Odometry message(const builtin_interfaces::msg::Time& stamp, const Pose& pose,
                                  const LevelMotion& motion) const {
    nav_msgs::msg::Odometry message;
    message.header.stamp = stamp;
    message.header.frame_id = frame_;
    message.child_frame_id = base_;
    message.pose.pose = pose_message(pose);
    message.twist.twist.linear = vector_message(motion.linear);
    message.twist.twist.angular.z = motion.turning;
    // Nothing is known of height, roll and pitch: 1e12.
    const double diagonal[] = {covariance_.x, covariance_.y, 1e12, 1e12, 1e12, covariance_.z};
    for (std::size_t i = 0; i < 6; ++i) message.pose.covariance[7 * i] = diagonal[i];
    return message;
  }

 private:
  std::string frame_, base_;
  Vector3 covariance_;  ///< of x, y and yaw
};

}  // namespace ros2wasm_sim
