// An action server whose goals are worked on by a behavior tree.
#pragma once

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_behavior_tree/behavior_tree_engine.hpp"
#include "nav2_behavior_tree/detail/tree_settings.hpp"
#include "nav2_behavior_tree/ros_topic_logger.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/simple_action_server.hpp"

namespace nav2_behavior_tree {

template <class ActionT>
class BtActionServer {
 public:
  using ActionServer = nav2_util::SimpleActionServer<ActionT>;
  /// False refuses the goal.
  using OnGoalReceivedCallback = std::function<bool(typename ActionT::Goal::ConstSharedPtr)>;
  using OnLoopCallback = std::function<void()>;
  using OnPreemptCallback = std::function<void(typename ActionT::Goal::ConstSharedPtr)>;
  using OnCompletionCallback =
      std::function<void(typename ActionT::Result::SharedPtr, nav2_behavior_tree::BtStatus)>;

  explicit BtActionServer(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                          const std::string& action_name,
                          const std::vector<std::string>& plugin_lib_names,
                          const std::string& default_bt_xml_filename,
                          OnGoalReceivedCallback on_goal_received_callback,
                          OnLoopCallback on_loop_callback, OnPreemptCallback on_preempt_callback,
                          OnCompletionCallback on_completion_callback)
      : action_name_(action_name),
        default_bt_xml_filename_(default_bt_xml_filename),
        plugin_lib_names_(plugin_lib_names),
        node_(parent),
        on_goal_received_callback_(std::move(on_goal_received_callback)),
        on_loop_callback_(std::move(on_loop_callback)),
        on_preempt_callback_(std::move(on_preempt_callback)),
        on_completion_callback_(std::move(on_completion_callback)) {
    const auto node = node_.lock();
    logger_ = node->get_logger();
    clock_ = node->get_clock();
    detail::declare_tree_parameters(*node);
  }
  ~BtActionServer() = default;

  bool on_configure() {
    const auto node = node_.lock();
    if (!node) throw std::runtime_error{"Failed to lock node"};
    client_node_ = detail::make_client_node(node, action_name_);
    settings_ = detail::read_tree_settings(*node);
    error_code_names_ = node->get_parameter("error_code_names").as_string_array();

    rcl_action_server_options_t options = rcl_action_server_get_default_options();
    options.result_timeout.nanoseconds = settings_.result_timeout.count();
    action_server_ = std::make_shared<ActionServer>(
        node->get_node_base_interface(), node->get_node_clock_interface(),
        node->get_node_logging_interface(), node->get_node_waitables_interface(), action_name_,
        [this] { executeCallback(); }, nullptr, std::chrono::milliseconds(500), false, options);

    bt_ = std::make_unique<BehaviorTreeEngine>(plugin_lib_names_, client_node_);
    blackboard_ = BT::Blackboard::create();
    detail::write_tree_settings(*blackboard_, client_node_, settings_);
    return true;
  }

  bool on_activate() {
    if (!loadBehaviorTree(default_bt_xml_filename_)) {
      RCLCPP_ERROR(logger_, "Error loading XML file: %s", default_bt_xml_filename_.c_str());
      return false;
    }
    action_server_->activate();
    return true;
  }

  bool on_deactivate() {
    action_server_->deactivate();
    return true;
  }

  bool on_cleanup() {
    if (bt_) {
      bt_->haltAllActions(tree_);
      bt_->resetGrootMonitor();
    }
    topic_logger_.reset();
    tree_ = BT::Tree();
    action_server_.reset();
    client_node_.reset();
    plugin_lib_names_.clear();
    current_bt_xml_filename_.clear();
    blackboard_.reset();
    bt_.reset();
    return true;
  }

  void setGrootMonitoring(const bool enable, const unsigned server_port) {
    enable_groot_monitoring_ = enable;
    groot_server_port_ = static_cast<int>(server_port);
  }

  /// The default for an empty name. A tree that is loaded is taken again, unless
  /// always_reload_bt_xml is set. After an error, which is logged, the tree before stays.
  bool loadBehaviorTree(const std::string& bt_xml_filename = "") {
    const std::string& filename =
        bt_xml_filename.empty() ? default_bt_xml_filename_ : bt_xml_filename;
    if (!settings_.always_reload && current_bt_xml_filename_ == filename) return true;
    if (!std::ifstream(filename).good()) {
      RCLCPP_ERROR(logger_, "Couldn't open input XML file: %s", filename.c_str());
      return false;
    }
    bt_->resetGrootMonitor();
    try {
      BT::Tree tree = bt_->createTreeFromFile(filename, blackboard_);
      for (const auto& subtree : tree.subtrees) {
        detail::write_tree_settings(*subtree->blackboard, client_node_, settings_);
      }
      topic_logger_.reset();
      tree_ = std::move(tree);
    } catch (const std::exception& error) {
      RCLCPP_ERROR(logger_, "Exception when loading BT: %s", error.what());
      return false;
    }
    topic_logger_ = std::make_unique<RosTopicLogger>(client_node_, tree_);
    current_bt_xml_filename_ = filename;
    if (enable_groot_monitoring_) {
      bt_->addGrootMonitoring(&tree_, static_cast<uint16_t>(groot_server_port_));
    }
    return true;
  }

  BT::Blackboard::Ptr getBlackboard() const { return blackboard_; }
  std::string getCurrentBTFilename() const { return current_bt_xml_filename_; }
  std::string getDefaultBTFilename() const { return default_bt_xml_filename_; }
  const std::shared_ptr<const typename ActionT::Goal> acceptPendingGoal() {
    return action_server_->accept_pending_goal();
  }
  void terminatePendingGoal() { action_server_->terminate_pending_goal(); }
  const std::shared_ptr<const typename ActionT::Goal> getCurrentGoal() const {
    return action_server_->get_current_goal();
  }
  const std::shared_ptr<const typename ActionT::Goal> getPendingGoal() const {
    return action_server_->get_pending_goal();
  }
  void publishFeedback(typename std::shared_ptr<typename ActionT::Feedback> feedback) {
    action_server_->publish_feedback(feedback);
  }
  const BT::Tree& getTree() const { return tree_; }
  void haltTree() { tree_.haltTree(); }

 protected:
  void executeCallback() {
    if (!on_goal_received_callback_(action_server_->get_current_goal())) {
      action_server_->terminate_current();
      cleanErrorCodes();
      return;
    }
    const auto is_canceling = [this] {
      return action_server_ == nullptr || !action_server_->is_server_active() ||
             action_server_->is_cancel_requested();
    };
    const auto on_loop = [this] {
      if (action_server_->is_preempt_requested() && on_preempt_callback_) {
        on_preempt_callback_(action_server_->get_pending_goal());
      }
      topic_logger_->flush();
      on_loop_callback_();
    };
    BtStatus status = bt_->run(&tree_, on_loop, is_canceling, settings_.loop_duration);
    try {
      bt_->haltAllActions(tree_);
    } catch (const std::exception& error) {
      RCLCPP_ERROR(logger_, "Behavior tree threw exception while it was halted: %s", error.what());
      status = BtStatus::FAILED;
    }
    topic_logger_->flush();
    auto result = std::make_shared<typename ActionT::Result>();
    populateErrorCode(result);
    on_completion_callback_(result, status);
    switch (status) {
      case BtStatus::SUCCEEDED:
        action_server_->succeeded_current(result);
        RCLCPP_INFO(logger_, "Goal succeeded");
        break;
      case BtStatus::FAILED:
        action_server_->terminate_current(result);
        RCLCPP_ERROR(logger_, "Goal failed");
        break;
      case BtStatus::CANCELED:
        action_server_->terminate_all(result);
        RCLCPP_INFO(logger_, "Goal canceled");
        break;
    }
    cleanErrorCodes();
  }

  /// The least code on the blackboard that is not 0.
  void populateErrorCode(typename std::shared_ptr<typename ActionT::Result> result) {
    const auto code = detail::least_error_code(*blackboard_, error_code_names_);
    if (code) result->error_code = *code;
  }

  void cleanErrorCodes() {
    for (const std::string& name : error_code_names_) blackboard_->set<uint16_t>(name, 0);
  }

  std::string action_name_;
  std::shared_ptr<ActionServer> action_server_;
  BT::Tree tree_;
  BT::Blackboard::Ptr blackboard_;  ///< of the root, which subtrees see by their ports
  std::string current_bt_xml_filename_;
  std::string default_bt_xml_filename_;
  std::unique_ptr<BehaviorTreeEngine> bt_;
  std::vector<std::string> plugin_lib_names_;
  std::vector<std::string> error_code_names_;
  rclcpp::Node::SharedPtr client_node_;  ///< for the nodes of the tree; nobody spins it
  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("BtActionServer")};
  std::unique_ptr<RosTopicLogger> topic_logger_;
  detail::TreeSettings settings_;
  bool enable_groot_monitoring_ = false;
  int groot_server_port_ = 1667;
  OnGoalReceivedCallback on_goal_received_callback_;
  OnLoopCallback on_loop_callback_;
  OnPreemptCallback on_preempt_callback_;
  OnCompletionCallback on_completion_callback_;
};

}  // namespace nav2_behavior_tree
