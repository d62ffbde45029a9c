// Looks transforms up in the buffer of another program.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "tf2/time.hpp"
#include "tf2_msgs/action/lookup_transform.hpp"
#include "tf2_ros/buffer_interface.hpp"
#include "tf2_ros/visibility_control.hpp"

namespace tf2_ros {

/// Base class of the errors of the action itself.
class LookupTransformGoalException : public std::runtime_error {
 public:
  explicit LookupTransformGoalException(const std::string& message) : std::runtime_error(message) {}
};
class GoalRejectedException : public LookupTransformGoalException {
 public:
  using LookupTransformGoalException::LookupTransformGoalException;
};
class GoalAbortedException : public LookupTransformGoalException {
 public:
  using LookupTransformGoalException::LookupTransformGoalException;
};
class GoalCanceledException : public LookupTransformGoalException {
 public:
  using LookupTransformGoalException::LookupTransformGoalException;
};
class UnexpectedResultCodeException : public LookupTransformGoalException {
 public:
  using LookupTransformGoalException::LookupTransformGoalException;
};

/// The other side is tf2_ros::BufferServer. Every lookup waits, so the node has to be spun by
/// another thread.
class BufferClient : public BufferInterface {
 public:
  using LookupTransformAction = tf2_msgs::action::LookupTransform;

  /// `ns`: the name of the action. The answer is looked for `check_frequency` times a second, and
  /// may come `timeout_padding` later than asked for.
  template <typename NodePtr>
  BufferClient(NodePtr node, const std::string ns, const double& check_frequency = 10.0,
               const tf2::Duration& timeout_padding = tf2::durationFromSec(2.0))
      : client_(rclcpp_action::create_client<LookupTransformAction>(node, ns)),
        check_frequency_(check_frequency),
        timeout_padding_(timeout_padding) {}

  /// Throws what a buffer would, tf2::ConnectivityException when there is no server, and a
  /// LookupTransformGoalException.
  geometry_msgs::msg::TransformStamped lookupTransform(
      const std::string& target_frame, const std::string& source_frame, const tf2::TimePoint& time,
      const tf2::Duration timeout = tf2::durationFromSec(0.0)) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
      const std::string& target_frame, const tf2::TimePoint& target_time,
      const std::string& source_frame, const tf2::TimePoint& source_time,
      const std::string& fixed_frame,
      const tf2::Duration timeout = tf2::durationFromSec(0.0)) const override;
  bool canTransform(const std::string& target_frame, const std::string& source_frame,
                    const tf2::TimePoint& time,
                    const tf2::Duration timeout = tf2::durationFromSec(0.0),
                    std::string* errstr = nullptr) const override;
  bool canTransform(const std::string& target_frame, const tf2::TimePoint& target_time,
                    const std::string& source_frame, const tf2::TimePoint& source_time,
                    const std::string& fixed_frame,
                    const tf2::Duration timeout = tf2::durationFromSec(0.0),
                    std::string* errstr = nullptr) const override;
  /// Whether there is a server in time.
  bool waitForServer(const tf2::Duration& timeout = tf2::durationFromSec(0)) {
    return client_->wait_for_action_server(timeout);
  }

 private:
  geometry_msgs::msg::TransformStamped ask(const LookupTransformAction::Goal& goal) const;

  rclcpp_action::Client<LookupTransformAction>::SharedPtr client_;
  double check_frequency_;
  tf2::Duration timeout_padding_;
};

}  // namespace tf2_ros
