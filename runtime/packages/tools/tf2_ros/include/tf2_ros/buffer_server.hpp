// Answers lookups of other programs, as an action.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/create_timer.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "tf2/buffer_core_interface.hpp"
#include "tf2/time.hpp"
#include "tf2_msgs/action/lookup_transform.hpp"
#include "tf2_ros/visibility_control.hpp"

namespace tf2_ros {

/// The other side is tf2_ros::BufferClient. Needs someone who fills `buffer`, and that the node is
/// spun.
class BufferServer {
  using LookupTransformAction = tf2_msgs::action::LookupTransform;
  using GoalHandle = std::shared_ptr<rclcpp_action::ServerGoalHandle<LookupTransformAction>>;

 public:
  /// `ns`: the name of the action. What cannot be answered yet is looked at every `check_period`.
  template <typename NodePtr>
  BufferServer(const tf2::BufferCoreInterface& buffer, NodePtr node, const std::string& ns,
               tf2::Duration check_period = tf2::durationFromSec(0.01))
      : buffer_(buffer), logger_(node->get_logger()) {
    rcl_action_server_options_t options = rcl_action_server_get_default_options();
    options.result_timeout.nanoseconds = RCL_S_TO_NS(5);
    server_ = rclcpp_action::create_server<LookupTransformAction>(
        node, ns,
        [](const rclcpp_action::GoalUUID&, std::shared_ptr<const LookupTransformAction::Goal>) {
          return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
        },
        [this](GoalHandle handle) { return on_cancel(handle); },
        [this](GoalHandle handle) { on_accepted(handle); }, options);
    check_timer_ = rclcpp::create_timer(node, node->get_clock(), rclcpp::Duration(check_period),
                                        [this] { check_transforms(); });
    RCLCPP_DEBUG(logger_, "Buffer server started");
  }

 private:
  struct GoalInfo {
    GoalHandle handle;
    tf2::TimePoint end_time;
  };

  void on_accepted(const GoalHandle& handle);
  rclcpp_action::CancelResponse on_cancel(const GoalHandle& handle);
  void check_transforms();
  bool can_transform(const LookupTransformAction::Goal& goal) const;
  /// The transform, or why there is none.
  LookupTransformAction::Result::SharedPtr look_up(const LookupTransformAction::Goal& goal) const;

  const tf2::BufferCoreInterface& buffer_;
  rclcpp::Logger logger_;
  rclcpp_action::Server<LookupTransformAction>::SharedPtr server_;
  std::list<GoalInfo> active_goals_;
  std::mutex mutex_;
  rclcpp::TimerBase::SharedPtr check_timer_;
};

}  // namespace tf2_ros
