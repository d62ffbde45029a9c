// Conditions on places, goals, times and error codes.
#include <set>
#include <string>
#include <vector>

#include "nav2_behavior_tree/bt_utils.hpp"
#include "nav2_msgs/action/compute_path_through_poses.hpp"
#include "nav2_msgs/action/compute_path_to_pose.hpp"
#include "nav2_msgs/action/follow_path.hpp"
#include "nav2_msgs/action/smooth_path.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nodes/registration.hpp"
#include "nodes/tree_state.hpp"

namespace nav2_behavior_tree {
namespace {

using BT::ConditionNode;
using BT::InputPort;
using BT::NodeStatus;
using geometry_msgs::msg::PoseStamped;
using nav2_util::geometry_utils::euclidean_distance;
using nav_msgs::msg::Path;
namespace action = nav2_msgs::action;

NodeStatus answer(bool is_so) {
  return is_so ? NodeStatus::SUCCESS : NodeStatus::FAILURE;
}

double number(const BT::TreeNode& node, const char* port) {
  double value = 0.0;
  node.getInput(port, value);
  return value;
}

class ArePosesNear : public ConditionNode {
 public:
  ArePosesNear(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf), robot_(*this) {}

  static BT::PortsList providedPorts() {
    return {InputPort<PoseStamped>("ref_pose", "A pose"),
            InputPort<PoseStamped>("target_pose", "Another pose"),
            InputPort<std::string>("global_frame", "Frame for both, when theirs differ"),
            InputPort<double>("tolerance", 0.5, "Greatest distance [m]")};
  }

  NodeStatus tick() override {
    PoseStamped one;
    PoseStamped other;
    getInput("ref_pose", one);
    getInput("target_pose", other);
    if (one.header.frame_id != other.header.frame_id &&
        !(robot_.transform(one, one) && robot_.transform(other, other))) {
      RCLCPP_ERROR(ros_node_of(*this)->get_logger(), "Failed to transform poses to the same frame");
      return NodeStatus::FAILURE;
    }
    return answer(euclidean_distance(one, other) <= number(*this, "tolerance"));
  }

 private:
  RobotPlace robot_;
};

/// Once for each so many metres.
class DistanceTraveled : public ConditionNode {
 public:
  DistanceTraveled(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf), robot_(*this) {}

  static BT::PortsList providedPorts() {
    return RobotPlace::ports({InputPort<double>("distance", 1.0, "Metres")});
  }

  NodeStatus tick() override {
    if (!BT::isStatusActive(status())) {
      robot_.find_or_note(start_);
      return NodeStatus::FAILURE;
    }
    PoseStamped pose;
    if (!robot_.find_or_note(pose)) return NodeStatus::FAILURE;
    if (euclidean_distance(start_, pose) < number(*this, "distance")) return NodeStatus::FAILURE;
    start_ = pose;
    return NodeStatus::SUCCESS;
  }

 private:
  RobotPlace robot_;
  PoseStamped start_;
};

class GoalReached : public ConditionNode {
 public:
  GoalReached(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf), robot_(*this) {
    ros_node_of(*this)->get_parameter_or<double>("goal_reached_tol", tolerance_, 0.25);
  }

  static BT::PortsList providedPorts() {
    return RobotPlace::ports({InputPort<PoseStamped>("goal", "The goal")});
  }

  NodeStatus tick() override {
    PoseStamped goal;
    PoseStamped pose;
    getInput("goal", goal);
    return answer(robot_.find(pose, goal.header.frame_id) &&
                  euclidean_distance(goal, pose) <= tolerance_);
  }

 private:
  RobotPlace robot_;
  double tolerance_ = 0.25;  ///< [m]
};

/// Since the node was idle.
class GoalUpdated : public ConditionNode {
 public:
  GoalUpdated(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf), goal_(*this) {}
  static BT::PortsList providedPorts() { return GoalWatch::ports(); }

  NodeStatus tick() override {
    if (BT::isStatusActive(status())) return answer(goal_.has_changed());
    goal_.take();
    return NodeStatus::FAILURE;
  }

 private:
  GoalWatch goal_;
};

/// Since it was asked last; the first goal is new.
class GlobalUpdatedGoal : public ConditionNode {
 public:
  GlobalUpdatedGoal(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf), goal_(*this) {}
  static BT::PortsList providedPorts() { return GoalWatch::ports(); }

  NodeStatus tick() override {
    if (!is_first_) return answer(goal_.has_changed());
    is_first_ = false;
    goal_.take();
    return NodeStatus::SUCCESS;
  }

 private:
  GoalWatch goal_;
  bool is_first_ = true;
};

class InitialPoseReceived : public ConditionNode {
 public:
  using ConditionNode::ConditionNode;
  static BT::PortsList providedPorts() { return {InputPort<bool>("initial_pose_received")}; }

  NodeStatus tick() override {
    bool is_received = false;
    BT::getInputPortOrBlackboard(*this, *config().blackboard, "initial_pose_received", is_received);
    return answer(is_received);
  }
};

/// Once for each so many seconds.
class TimeExpired : public ConditionNode {
 public:
  using ConditionNode::ConditionNode;

  static BT::PortsList providedPorts() { return {InputPort<double>("seconds", 1.0, "Seconds")}; }

  NodeStatus tick() override {
    const rclcpp::Time now = ros_node_of(*this)->now();
    if (BT::isStatusActive(status())) {
      if ((now - start_).seconds() < number(*this, "seconds")) return NodeStatus::FAILURE;
      start_ = now;
      return NodeStatus::SUCCESS;
    }
    start_ = now;
    return NodeStatus::FAILURE;
  }

 private:
  rclcpp::Time start_;
};

/// Once for each so many seconds with the same path.
class PathExpiringTimer : public ConditionNode {
 public:
  PathExpiringTimer(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf), node_(ros_node_of(*this)) {}

  static BT::PortsList providedPorts() {
    return {InputPort<double>("seconds", 1.0, "Seconds"), InputPort<Path>("path")};
  }

  NodeStatus tick() override {
    const rclcpp::Time now = node_->now();
    Path path;
    getInput("path", path);
    if (is_first_ || path != path_) start_ = now;
    path_ = path;
    if (std::exchange(is_first_, false)) return NodeStatus::FAILURE;
    if ((now - start_).seconds() < number(*this, "seconds")) return NodeStatus::FAILURE;
    start_ = now;
    return NodeStatus::SUCCESS;
  }

 private:
  rclcpp::Node::SharedPtr node_;
  rclcpp::Time start_;
  Path path_;
  bool is_first_ = true;
};

/// Once it was there, it counts as there.
class TransformAvailable : public ConditionNode {
 public:
  TransformAvailable(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf),
        buffer_(conf.blackboard->get<std::shared_ptr<tf2_ros::Buffer>>("tf_buffer")) {}

  static BT::PortsList providedPorts() {
    return {InputPort<std::string>("child", "", "A frame"),
            InputPort<std::string>("parent", "", "Another frame")};
  }

  NodeStatus tick() override {
    if (was_found_) return NodeStatus::SUCCESS;
    std::string child;
    std::string parent;
    getInput("child", child);
    getInput("parent", parent);
    const auto logger = ros_node_of(*this)->get_logger();
    if (child.empty() || parent.empty()) {
      RCLCPP_FATAL(logger, "Child frame (%s) or parent frame (%s) were empty.", child.c_str(),
                   parent.c_str());
      throw std::runtime_error("TransformAvailableCondition: Child or parent frames not provided!");
    }
    std::string error;
    was_found_ = buffer_->canTransform(child, parent, tf2::TimePointZero, &error);
    if (!was_found_) {
      RCLCPP_INFO(logger, "Transform from %s to %s was not found, tf error: %s", child.c_str(),
                  parent.c_str(), error.c_str());
    }
    return answer(was_found_);
  }

 private:
  std::shared_ptr<tf2_ros::Buffer> buffer_;
  bool was_found_ = false;
};

class AreErrorCodesPresent : public ConditionNode {
 public:
  AreErrorCodesPresent(const std::string& name, const BT::NodeConfiguration& conf)
      : ConditionNode(name, conf) {
    std::vector<int> codes;
    getInput("error_codes_to_check", codes);
    codes_.insert(codes.begin(), codes.end());
  }
  AreErrorCodesPresent(const std::string& name, const BT::NodeConfiguration& conf,
                       std::set<int> codes)
      : ConditionNode(name, conf), codes_(std::move(codes)) {}

  static BT::PortsList providedPorts() {
    return {InputPort<uint16_t>("error_code", "The code"),
            InputPort<std::vector<int>>("error_codes_to_check", "The codes that it may be")};
  }

  NodeStatus tick() override {
    uint16_t code = 0;
    return answer(getInput("error_code", code) && codes_.count(code) != 0);
  }

 private:
  std::set<int> codes_;
};

/// Errors after which a recovery may help.
void register_codes(Factory& factory, const char* id, const std::set<int>& codes) {
  factory.registerNodeType<AreErrorCodesPresent>(id, AreErrorCodesPresent::providedPorts(), codes);
}

const NodeLibrary poses_near("libnav2_are_poses_near_condition_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<ArePosesNear>("ArePosesNear");
});
const NodeLibrary distance("libnav2_distance_traveled_condition_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<DistanceTraveled>("DistanceTraveled");
});
const NodeLibrary reached("libnav2_goal_reached_condition_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<GoalReached>("GoalReached");
});
const NodeLibrary updated("libnav2_goal_updated_condition_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<GoalUpdated>("GoalUpdated");
});
const NodeLibrary globally_updated("libnav2_globally_updated_goal_condition_bt_node.so",
                                   [](Factory& factory) {
                                     factory.registerNodeType<GlobalUpdatedGoal>(
                                         "GlobalUpdatedGoal");
                                   });
const NodeLibrary initial_pose("libnav2_initial_pose_received_condition_bt_node.so",
                               [](Factory& factory) {
                                 factory.registerNodeType<InitialPoseReceived>(
                                     "InitialPoseReceived");
                               });
const NodeLibrary time_expired("libnav2_time_expired_condition_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<TimeExpired>("TimeExpired");
});
const NodeLibrary path_expires("libnav2_path_expiring_timer_condition.so", [](Factory& factory) {
  factory.registerNodeType<PathExpiringTimer>("PathExpiringTimer");
});
const NodeLibrary transform("libnav2_transform_available_condition_bt_node.so",
                            [](Factory& factory) {
                              factory.registerNodeType<TransformAvailable>("TransformAvailable");
                            });
const NodeLibrary codes("libnav2_are_error_codes_active_condition_bt_node.so",
                        [](Factory& factory) {
                          factory.registerNodeType<AreErrorCodesPresent>("AreErrorCodesPresent");
                        });
const NodeLibrary controller_codes("libnav2_would_a_controller_recovery_help_condition_bt_node.so",
                                   [](Factory& factory) {
                                     using Result = action::FollowPath::Result;
                                     register_codes(factory, "WouldAControllerRecoveryHelp",
                                                    {Result::UNKNOWN, Result::PATIENCE_EXCEEDED,
                                                     Result::FAILED_TO_MAKE_PROGRESS,
                                                     Result::NO_VALID_CONTROL});
                                   });
const NodeLibrary planner_codes("libnav2_would_a_planner_recovery_help_condition_bt_node.so",
                                [](Factory& factory) {
                                  using ToPose = action::ComputePathToPose::Result;
                                  using Through = action::ComputePathThroughPoses::Result;
                                  register_codes(
                                      factory, "WouldAPlannerRecoveryHelp",
                                      {ToPose::UNKNOWN, ToPose::NO_VALID_PATH, ToPose::TIMEOUT,
                                       Through::UNKNOWN, Through::TIMEOUT, Through::NO_VALID_PATH});
                                });
const NodeLibrary smoother_codes("libnav2_would_a_smoother_recovery_help_condition_bt_node.so",
                                 [](Factory& factory) {
                                   using Result = action::SmoothPath::Result;
                                   register_codes(factory, "WouldASmootherRecoveryHelp",
                                                  {Result::UNKNOWN, Result::TIMEOUT,
                                                   Result::FAILED_TO_SMOOTH_PATH,
                                                   Result::SMOOTHED_PATH_IN_COLLISION});
                                 });

}  // namespace
}  // namespace nav2_behavior_tree
