// The base of plugins that navigate by a behavior tree: each is an action server.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "nav2_behavior_tree/bt_action_server.hpp"
#include "nav2_util/odometry_utils.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_core {

/// For feedback: where the robot is.
struct FeedbackUtils {
  std::string robot_frame;
  std::string global_frame;
  double transform_tolerance;  ///< [s]
  std::shared_ptr<tf2_ros::Buffer> tf;
};

/// Lets one navigator work at a time.
class NavigatorMuxer {
 public:
  NavigatorMuxer() = default;

  bool isNavigating() {
    const std::scoped_lock lock(mutex_);
    return !current_navigator_.empty();
  }
  void startNavigating(const std::string& navigator_name) {
    const std::scoped_lock lock(mutex_);
    if (!current_navigator_.empty()) log_error("requested");
    current_navigator_ = navigator_name;
  }
  void stopNavigating(const std::string& navigator_name) {
    const std::scoped_lock lock(mutex_);
    if (current_navigator_ != navigator_name) {
      log_error("stopped");
    } else {
      current_navigator_.clear();
    }
  }

 protected:
  std::string current_navigator_;
  std::mutex mutex_;

 private:
  static void log_error(const char* what) {
    RCLCPP_ERROR(rclcpp::get_logger("NavigatorMutex"),
                 "Major error! Navigation %s while another navigation task is in progress! This "
                 "likely occurred from an incorrect implementation of a navigator plugin.",
                 what);
  }
};

/// The bt_navigator sees its plugins as these.
class NavigatorBase {
 public:
  NavigatorBase() = default;
  virtual ~NavigatorBase() = default;

  virtual bool on_configure(rclcpp_lifecycle::LifecycleNode::WeakPtr parent_node,
                            const std::vector<std::string>& plugin_lib_names,
                            const FeedbackUtils& feedback_utils,
                            nav2_core::NavigatorMuxer* plugin_muxer,
                            std::shared_ptr<nav2_util::OdomSmoother> odom_smoother) = 0;
  virtual bool on_activate() = 0;
  virtual bool on_deactivate() = 0;
  virtual bool on_cleanup() = 0;
};

/// A plugin derives from this, with its action.
template <class ActionT>
class BehaviorTreeNavigator : public NavigatorBase {
 public:
  using Ptr = std::shared_ptr<nav2_core::BehaviorTreeNavigator<ActionT>>;

  BehaviorTreeNavigator() = default;
  ~BehaviorTreeNavigator() override = default;

  bool on_configure(rclcpp_lifecycle::LifecycleNode::WeakPtr parent_node,
                    const std::vector<std::string>& plugin_lib_names,
                    const FeedbackUtils& feedback_utils, nav2_core::NavigatorMuxer* plugin_muxer,
                    std::shared_ptr<nav2_util::OdomSmoother> odom_smoother) final {
    const auto node = parent_node.lock();
    logger_ = node->get_logger();
    clock_ = node->get_clock();
    feedback_utils_ = feedback_utils;
    plugin_muxer_ = plugin_muxer;
    bt_action_server_ = std::make_unique<nav2_behavior_tree::BtActionServer<ActionT>>(
        node, getName(), plugin_lib_names, getDefaultBTFilepath(parent_node),
        [this](typename ActionT::Goal::ConstSharedPtr goal) { return onGoalReceived(goal); },
        [this] { onLoop(); },
        [this](typename ActionT::Goal::ConstSharedPtr goal) { onPreempt(goal); },
        [this](typename ActionT::Result::SharedPtr result, nav2_behavior_tree::BtStatus status) {
          onCompletion(result, status);
        });
    const bool is_configured = bt_action_server_->on_configure();
    BT::Blackboard& blackboard = *bt_action_server_->getBlackboard();
    blackboard.set("tf_buffer", feedback_utils.tf);
    blackboard.set("initial_pose_received", false);
    blackboard.set("number_recoveries", 0);
    blackboard.set("odom_smoother", odom_smoother);
    return configure(parent_node, odom_smoother) && is_configured;
  }

  bool on_activate() final {
    const bool is_active = bt_action_server_->on_activate();
    return activate() && is_active;
  }

  bool on_deactivate() final {
    const bool is_inactive = bt_action_server_->on_deactivate();
    return deactivate() && is_inactive;
  }

  bool on_cleanup() final {
    const bool is_clean = !bt_action_server_ || bt_action_server_->on_cleanup();
    bt_action_server_.reset();
    return cleanup() && is_clean;
  }

  virtual std::string getDefaultBTFilepath(rclcpp_lifecycle::LifecycleNode::WeakPtr node) = 0;
  /// The name of the action.
  virtual std::string getName() = 0;

 protected:
  bool onGoalReceived(typename ActionT::Goal::ConstSharedPtr goal) {
    if (plugin_muxer_->isNavigating()) {
      RCLCPP_ERROR(logger_,
                   "Requested navigation from %s while another navigator is processing, rejecting "
                   "request.",
                   getName().c_str());
      return false;
    }
    if (!goalReceived(goal)) return false;
    plugin_muxer_->startNavigating(getName());
    return true;
  }

  void onCompletion(typename ActionT::Result::SharedPtr result,
                    const nav2_behavior_tree::BtStatus final_bt_status) {
    plugin_muxer_->stopNavigating(getName());
    goalCompleted(result, final_bt_status);
  }

  /// Writes the goal to the blackboard; false refuses it.
  virtual bool goalReceived(typename ActionT::Goal::ConstSharedPtr goal) = 0;
  /// After each tick.
  virtual void onLoop() = 0;
  /// A newer goal waits.
  virtual void onPreempt(typename ActionT::Goal::ConstSharedPtr goal) = 0;
  virtual void goalCompleted(typename ActionT::Result::SharedPtr result,
                             const nav2_behavior_tree::BtStatus final_bt_status) = 0;
  virtual bool configure(rclcpp_lifecycle::LifecycleNode::WeakPtr /*node*/,
                         std::shared_ptr<nav2_util::OdomSmoother> /*odom_smoother*/) {
    return true;
  }
  virtual bool cleanup() { return true; }
  virtual bool activate() { return true; }
  virtual bool deactivate() { return true; }

  std::unique_ptr<nav2_behavior_tree::BtActionServer<ActionT>> bt_action_server_;
  rclcpp::Logger logger_{rclcpp::get_logger("Navigator")};
  rclcpp::Clock::SharedPtr clock_;
  FeedbackUtils feedback_utils_;
  NavigatorMuxer* plugin_muxer_ = nullptr;  ///< of the bt_navigator
};

}  // namespace nav2_core
