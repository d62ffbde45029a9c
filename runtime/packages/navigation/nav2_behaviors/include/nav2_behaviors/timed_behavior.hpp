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

/// Parts of a behaviour that do not depend on its action. They are compiled once.
class BehaviorParts {
 protected:
  enum class Interruption : int8_t { NONE, INACTIVE, PREEMPTED, CANCELED };

  /// Reads parameters; returns the node.
  nav2_util::LifecycleNode::SharedPtr setUp(
      const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, const std::string& name,
      std::shared_ptr<tf2_ros::Buffer> tf,
      std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> local_collision_checker,
      std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> global_collision_checker);
  /// Whether a goal may run.
  bool isReady() const;
  void logInterruption(Interruption why) const;
  void logEnd(bool succeeded) const;
  void setEnabled(bool enabled);
  /// Publishes a velocity of zero.
  void stopRobot();

  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  std::string behavior_name_;
  std::unique_ptr<nav2_util::TwistPublisher> vel_pub_;
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
  rclcpp::Duration elasped_time_{0, 0};  // since the goal was taken; upstream's spelling
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_behaviors")};
  rcl_action_server_options_t server_options_ = rcl_action_server_get_default_options();
  rclcpp::Time start_time_;  // of the goal
};

template <typename ActionT>
class TimedBehavior : public nav2_core::Behavior, protected BehaviorParts {
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
    const auto node = setUp(parent, name, tf, local_collision_checker, global_collision_checker);
    // The robot stops after an exception in the work, and when the work does not end in time.
    action_server_ = std::make_shared<ActionServer>(
        node, behavior_name_, [this] { execute(); }, [this] { stopRobot(); }, 500ms, false,
        server_options_);
    onConfigure();
  }

  void cleanup() override {
    action_server_.reset();
    vel_pub_.reset();
    onCleanup();
  }

  void activate() override {
    setEnabled(true);
    action_server_->activate();
  }

  void deactivate() override {
    // The work may end with a velocity of zero, so its publisher is the last.
    action_server_->deactivate();
    setEnabled(false);
  }

 protected:
  /// The work of a goal.
  void execute() {
    if (!isReady()) return;
    const auto goal = action_server_->get_current_goal();
    // The server was deactivated before this thread began.
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

  std::shared_ptr<ActionServer> action_server_;

 private:
  using ResultPtr = std::shared_ptr<typename ActionT::Result>;

  Interruption interruption() {
    if (!action_server_->is_server_active()) return Interruption::INACTIVE;
    if (action_server_->is_preempt_requested()) return Interruption::PREEMPTED;
    return action_server_->is_cancel_requested() ? Interruption::CANCELED : Interruption::NONE;
  }

  /// Whether somebody else ends the goal. The robot stops then.
  bool isInterrupted(const ResultPtr& result) {
    elasped_time_ = clock_->now() - start_time_;
    const Interruption why = interruption();
    if (why == Interruption::NONE) return false;
    logInterruption(why);
    stopRobot();
    finish(result);
    // The goal that preempts has its turn next.
    why == Interruption::PREEMPTED ? action_server_->terminate_current(result)
                                   : action_server_->terminate_all(result);
    return true;
  }

  bool isFinished(const ResultPtr& result) {
    const ResultStatus cycle = onCycleUpdate();
    const bool succeeded = cycle.status == Status::SUCCEEDED;
    if (!succeeded && cycle.status != Status::FAILED) return false;
    logEnd(succeeded);
    if (!succeeded) result->error_code = cycle.error_code;
    finish(result);
    succeeded ? action_server_->succeeded_current(result)
              : action_server_->terminate_current(result);
    return true;
  }

  void finish(const ResultPtr& result) {
    result->total_elapsed_time = clock_->now() - start_time_;
    onActionCompletion(result);
  }
};

}  // namespace nav2_behaviors
