// The base that behaviours derive from: an action whose work is one function, called
// `cycle_frequency` times a second until it succeeds or fails.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_core/behavior.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/robot_utils.hpp"
#include "nav2_util/simple_action_server.hpp"
#include "nav2_util/twist_publisher.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/utils.h"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/transform_listener.h"

namespace nav2_behaviors {

enum class Status : int8_t {
  SUCCEEDED = 1,
  FAILED = 2,
  RUNNING = 3,
};

struct ResultStatus {
  Status status;
  uint16_t error_code{0};  // of the action's result
};

// Behaviours of the workspace rely on it.
using namespace std::chrono_literals;  // NOLINT

template <typename ActionT>
class TimedBehavior : public nav2_core::Behavior {
 public:
  using ActionServer = nav2_util::SimpleActionServer<ActionT>;

  TimedBehavior() = default;
  virtual ~TimedBehavior() = default;

  /// Takes a goal. Anything but SUCCEEDED refuses it.
  virtual ResultStatus onRun(const std::shared_ptr<const typename ActionT::Goal> command) = 0;
  /// The work of one cycle. It publishes velocities, also the last one.
  virtual ResultStatus onCycleUpdate() = 0;
  virtual void onConfigure() {}
  virtual void onCleanup() {}
  /// Runs before the result of an accepted goal is sent.
  virtual void onActionCompletion(std::shared_ptr<typename ActionT::Result> /*result*/) {}

  void configure(
      const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, const std::string& name,
      std::shared_ptr<tf2_ros::Buffer> tf,
      std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> local_collision_checker,
      std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> global_collision_checker)
      override {
    node_ = parent;
    const auto node = std::static_pointer_cast<nav2_util::LifecycleNode>(parent.lock());
    logger_ = node->get_logger();
    clock_ = node->get_clock();
    RCLCPP_INFO(logger_, "Configuring %s", name.c_str());
    behavior_name_ = name;
    tf_ = tf;
    local_collision_checker_ = local_collision_checker;
    global_collision_checker_ = global_collision_checker;
    node->get_parameter("cycle_frequency", cycle_frequency_);
    node->get_parameter("local_frame", local_frame_);
    node->get_parameter("global_frame", global_frame_);
    node->get_parameter("robot_base_frame", robot_base_frame_);
    node->get_parameter("transform_tolerance", transform_tolerance_);
    nav2_util::declare_parameter_if_not_declared(node, "action_server_result_timeout",
                                                 rclcpp::ParameterValue(10.0));
    rcl_action_server_options_t options = rcl_action_server_get_default_options();
    options.result_timeout.nanoseconds =
        RCL_S_TO_NS(node->get_parameter("action_server_result_timeout").as_double());
    // After an exception in the work, or when it does not end in time, the robot stands.
    action_server_ = std::make_shared<ActionServer>(
        node, behavior_name_, [this] { execute(); }, [this] { stopRobot(); }, 500ms, false,
        options);
    vel_pub_ = std::make_unique<nav2_util::TwistPublisher>(node, "cmd_vel", 1);
    onConfigure();
  }

  void cleanup() override {
    action_server_.reset();
    vel_pub_.reset();
    onCleanup();
  }

  void activate() override {
    RCLCPP_INFO(logger_, "Activating %s", behavior_name_.c_str());
    vel_pub_->on_activate();
    action_server_->activate();
    enabled_ = true;
  }

  void deactivate() override {
    // The work may end with a velocity of zero, so its publisher is the last.
    action_server_->deactivate();
    vel_pub_->on_deactivate();
    enabled_ = false;
  }

 protected:
  /// The work of a goal.
  void execute() {
    RCLCPP_INFO(logger_, "Running %s", behavior_name_.c_str());
    if (!enabled_) {
      RCLCPP_WARN(logger_, "Called while inactive, ignoring request.");
      return;
    }
    const auto goal = action_server_->get_current_goal();
    // The server was deactivated meanwhile.
    if (!goal) return;
    const auto result = std::make_shared<typename ActionT::Result>();
    const ResultStatus taken = onRun(goal);
    if (taken.status != Status::SUCCEEDED) {
      RCLCPP_INFO(logger_, "Initial checks failed for %s", behavior_name_.c_str());
      result->error_code = taken.error_code;
      action_server_->terminate_current(result);
      return;
    }
    start_time_ = clock_->now();
    rclcpp::WallRate rate(cycle_frequency_);
    while (rclcpp::ok() && !isInterrupted(result) && !isFinished(result)) rate.sleep();
  }

  /// Publishes a velocity of zero.
  void stopRobot() {
    auto velocity = std::make_unique<geometry_msgs::msg::TwistStamped>();
    velocity->header.frame_id = robot_base_frame_;
    velocity->header.stamp = clock_->now();
    vel_pub_->publish(std::move(velocity));
  }

  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  std::string behavior_name_;
  std::unique_ptr<nav2_util::TwistPublisher> vel_pub_;
  std::shared_ptr<ActionServer> action_server_;
  /// Null unless getResourceInfo() of some behaviour asks for that costmap.
  std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> local_collision_checker_;
  std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> global_collision_checker_;
  std::shared_ptr<tf2_ros::Buffer> tf_;
  double cycle_frequency_ = 10.0;  // Hz
  bool enabled_ = false;
  std::string local_frame_;
  std::string global_frame_;
  std::string robot_base_frame_;
  double transform_tolerance_ = 0.0;     // s
  rclcpp::Duration elasped_time_{0, 0};  // since the goal was taken; the spelling is upstream's
  rclcpp::Duration& elapsed_time_{elasped_time_};  // its name in later versions
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_behaviors")};

 private:
  using ResultPtr = std::shared_ptr<typename ActionT::Result>;

  /// Whether somebody else ends the goal. The robot stops then.
  bool isInterrupted(const ResultPtr& result) {
    elasped_time_ = clock_->now() - start_time_;
    const bool is_active = action_server_->is_server_active();
    const bool is_preempted = action_server_->is_preempt_requested();
    if (is_active && !is_preempted && !action_server_->is_cancel_requested()) return false;
    if (!is_active) {
      RCLCPP_DEBUG(logger_, "Action server unavailable or inactive. Stopping.");
    } else if (is_preempted) {
      RCLCPP_ERROR(logger_,
                   "Received a preemption request for %s, however feature is currently not "
                   "implemented. Aborting and stopping.",
                   behavior_name_.c_str());
    } else {
      RCLCPP_INFO(logger_, "Canceling %s", behavior_name_.c_str());
    }
    stopRobot();
    finish(result);
    // A goal that waits has its turn after a preemption only.
    is_active&& is_preempted ? action_server_->terminate_current(result)
                             : action_server_->terminate_all(result);
    return true;
  }

  bool isFinished(const ResultPtr& result) {
    const ResultStatus cycle = onCycleUpdate();
    if (cycle.status == Status::SUCCEEDED) {
      RCLCPP_INFO(logger_, "%s completed successfully", behavior_name_.c_str());
      finish(result);
      action_server_->succeeded_current(result);
      return true;
    }
    if (cycle.status != Status::FAILED) return false;
    RCLCPP_WARN(logger_, "%s failed", behavior_name_.c_str());
    result->error_code = cycle.error_code;
    finish(result);
    action_server_->terminate_current(result);
    return true;
  }

  void finish(const ResultPtr& result) {
    result->total_elapsed_time = clock_->now() - start_time_;
    onActionCompletion(result);
  }

  rclcpp::Time start_time_;
};

}  // namespace nav2_behaviors
