// Nodes that tick their child less often, or with another goal.
#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "behaviortree_cpp/decorator_node.h"
#include "nav2_behavior_tree/bt_utils.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/odometry_utils.hpp"
#include "nodes/registration.hpp"
#include "nodes/tree_state.hpp"

namespace nav2_behavior_tree {
namespace {

using BT::DecoratorNode;
using BT::InputPort;
using BT::NodeStatus;
using geometry_msgs::msg::PoseStamped;
using nav_msgs::msg::Path;

/// The child once when it is new, while it runs, and whenever it is due.
class Throttle : public DecoratorNode {
 public:
  using DecoratorNode::DecoratorNode;

 private:
  NodeStatus tick() final {
    const bool is_new = !BT::isStatusActive(status());
    if (is_new && !begin()) return NodeStatus::FAILURE;
    if (is_new) is_first_ = true;
    setStatus(NodeStatus::RUNNING);
    const std::optional<bool> due = is_due();
    if (!due) return NodeStatus::FAILURE;
    if (!is_first_ && child_node_->status() != NodeStatus::RUNNING && !*due) return status();
    is_first_ = false;
    const NodeStatus answer = child_node_->executeTick();
    return answer == NodeStatus::SUCCESS && !end() ? NodeStatus::FAILURE : answer;
  }

  // False, or nothing, is a failure.
  virtual bool begin() = 0;
  virtual std::optional<bool> is_due() = 0;
  virtual bool end() { return true; }  ///< after the child's success

  bool is_first_ = true;
};

double number(const BT::TreeNode& node, const char* port) {
  double value = 0.0;
  node.getInput(port, value);
  return value;
}

/// So many times a second, from success to success.
class RateController : public Throttle {
 public:
  using Throttle::Throttle;
  static BT::PortsList providedPorts() { return {InputPort<double>("hz", 10.0, "Rate [Hz]")}; }

 private:
  using Clock = std::chrono::steady_clock;

  bool begin() override {
    double rate = 1.0;
    getInput("hz", rate);
    period_ = std::chrono::duration<double>(1.0 / rate);
    return end();
  }
  std::optional<bool> is_due() override { return Clock::now() - start_ >= period_; }
  bool end() override {
    start_ = Clock::now();
    return true;
  }

  std::chrono::duration<double> period_{0.1};
  Clock::time_point start_;
};

/// Each time the robot has moved so far, from success to success.
class DistanceController : public Throttle {
 public:
  DistanceController(const std::string& name, const BT::NodeConfiguration& conf)
      : Throttle(name, conf), robot_(*this) {}

  static BT::PortsList providedPorts() {
    return RobotPlace::ports({InputPort<double>("distance", 1.0, "Metres")});
  }

 private:
  bool begin() override { return robot_.find_or_note(start_); }
  std::optional<bool> is_due() override {
    PoseStamped pose;
    if (!robot_.find_or_note(pose)) return std::nullopt;
    return nav2_util::geometry_utils::euclidean_distance(start_, pose) >= number(*this, "distance");
  }
  bool end() override { return robot_.find_or_note(start_); }

  RobotPlace robot_;
  PoseStamped start_;
};

/// The more often the faster the robot is, and at once for a new goal.
class SpeedController : public Throttle {
 public:
  SpeedController(const std::string& name, const BT::NodeConfiguration& conf)
      : Throttle(name, conf),
        node_(ros_node_of(*this)),
        odometry_(conf.blackboard->get<std::shared_ptr<nav2_util::OdomSmoother>>("odom_smoother")),
        goal_(*this),
        rates_{number(*this, "min_rate"), number(*this, "max_rate")},
        speeds_{number(*this, "min_speed"), number(*this, "max_speed")} {
    if (rates_.first > 0.0 && rates_.second > 0.0) return;
    const std::string error = "SpeedController node cannot have rate <= 0.0";
    RCLCPP_FATAL(node_->get_logger(), "%s", error.c_str());
    throw BT::BehaviorTreeException(error);
  }

  static BT::PortsList providedPorts() {
    return GoalWatch::ports({InputPort<double>("min_rate", 0.1, "Rate at the least speed [Hz]"),
                             InputPort<double>("max_rate", 1.0, "Rate at the greatest speed [Hz]"),
                             InputPort<double>("min_speed", 0.0, "Least speed [m/s]"),
                             InputPort<double>("max_speed", 0.5, "Greatest speed [m/s]")});
  }

 private:
  bool begin() override {
    goal_.take();
    restart();
    return true;
  }

  std::optional<bool> is_due() override {
    const bool is_new_goal = goal_.has_changed();
    if (is_new_goal) restart();
    const rclcpp::Time now = node_->now();
    if ((now - start_).seconds() < period_) return is_new_goal;
    const auto& twist = odometry_->getTwist();
    const double speed = std::hypot(twist.linear.x, twist.linear.y);
    const double share = (speed - speeds_.first) / (speeds_.second - speeds_.first);
    const double rate =
        std::clamp(share * (rates_.second - rates_.first) + rates_.first,
                   std::min(rates_.first, rates_.second), std::max(rates_.first, rates_.second));
    period_ = 1.0 / rate;
    start_ = now;
    return true;
  }

  void restart() {
    period_ = 1.0 / rates_.second;
    start_ = node_->now();
  }

  rclcpp::Node::SharedPtr node_;
  std::shared_ptr<nav2_util::OdomSmoother> odometry_;
  GoalWatch goal_;
  std::pair<double, double> rates_;   ///< least and greatest [Hz]
  std::pair<double, double> speeds_;  ///< least and greatest [m/s]
  double period_ = 1.0;               ///< [s]
  rclcpp::Time start_;
};

/// For each new goal.
class GoalUpdatedController : public Throttle {
 public:
  GoalUpdatedController(const std::string& name, const BT::NodeConfiguration& conf)
      : Throttle(name, conf), goal_(*this) {}
  static BT::PortsList providedPorts() { return GoalWatch::ports(); }

 private:
  bool begin() override {
    goal_.take();
    return true;
  }
  std::optional<bool> is_due() override { return goal_.has_changed(); }

  GoalWatch goal_;
};

/// The child with the newest goal of a topic.
class GoalUpdater : public DecoratorNode {
 public:
  GoalUpdater(const std::string& name, const BT::NodeConfiguration& conf)
      : DecoratorNode(name, conf),
        topic_(ros_node_of(*this), topic_name(*this), rclcpp::SystemDefaultsQoS(),
               [this](const PoseStamped& goal) { newest_ = goal; }) {}

  static BT::PortsList providedPorts() {
    return {InputPort<PoseStamped>("input_goal", "The goal at first"),
            BT::OutputPort<PoseStamped>("output_goal", "The newest goal")};
  }

 private:
  static std::string topic_name(const BT::TreeNode& node) {
    std::string name;
    ros_node_of(node)->get_parameter_or<std::string>("goal_updater_topic", name, "goal_update");
    return name;
  }

  NodeStatus tick() override {
    PoseStamped goal;
    getInput("input_goal", goal);
    topic_.receive();
    const rclcpp::Time newest(newest_.header.stamp);
    if (newest.nanoseconds() != 0) {
      const rclcpp::Time before(goal.header.stamp);
      if (newest > before) {
        goal = newest_;
      } else {
        RCLCPP_WARN(ros_node_of(*this)->get_logger(),
                    "The timestamp of the received goal (%f) is older than the current goal (%f). "
                    "Ignoring the received goal.",
                    newest.seconds(), before.seconds());
      }
    }
    setOutput("output_goal", goal);
    return child_node_->executeTick();
  }

  PoseStamped newest_;
  TreeTopic<PoseStamped> topic_;
};

/// The child when a path to the same goal became much longer close to it.
class PathLongerOnApproach : public DecoratorNode {
 public:
  using DecoratorNode::DecoratorNode;

  static BT::PortsList providedPorts() {
    return {InputPort<Path>("path", "The path"),
            InputPort<double>("prox_len", 3.0, "Length of a path that is close to its end [m]"),
            InputPort<double>("length_factor", 2.0, "How much longer the new one is")};
  }

 private:
  NodeStatus tick() override {
    Path path;
    getInput("path", path);
    if (is_first_ || old_.poses.empty() || path.poses.empty() ||
        old_.poses.back().pose != path.poses.back().pose) {
      is_first_ = false;
      old_ = path;
      setStatus(NodeStatus::RUNNING);
      return NodeStatus::SUCCESS;
    }
    setStatus(NodeStatus::RUNNING);
    if (!is_longer(path)) {
      old_ = path;
      return NodeStatus::SUCCESS;
    }
    const NodeStatus answer = child_node_->executeTick();
    if (BT::isStatusCompleted(answer)) {
      old_ = path;
      resetChild();
    }
    return answer;
  }

  bool is_longer(const Path& path) const {
    using nav2_util::geometry_utils::calculate_path_length;
    const double before = calculate_path_length(old_);
    return path.poses.size() != old_.poses.size() && before < number(*this, "prox_len") &&
           calculate_path_length(path) > number(*this, "length_factor") * before;
  }

  Path old_;
  bool is_first_ = true;
};

/// The child until it has an answer, and a failure afterwards.
class SingleTrigger : public DecoratorNode {
 public:
  using DecoratorNode::DecoratorNode;
  static BT::PortsList providedPorts() { return {}; }

 private:
  NodeStatus tick() override {
    if (!BT::isStatusActive(status())) is_done_ = false;
    setStatus(NodeStatus::RUNNING);
    if (is_done_) return NodeStatus::FAILURE;
    const NodeStatus answer = child_node_->executeTick();
    is_done_ = BT::isStatusCompleted(answer);
    return answer;
  }

  bool is_done_ = false;
};

const NodeLibrary rate("libnav2_rate_controller_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<RateController>("RateController");
});
const NodeLibrary distance("libnav2_distance_controller_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<DistanceController>("DistanceController");
});
const NodeLibrary speed("libnav2_speed_controller_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<SpeedController>("SpeedController");
});
const NodeLibrary updated("libnav2_goal_updated_controller_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<GoalUpdatedController>("GoalUpdatedController");
});
const NodeLibrary updater("libnav2_goal_updater_node_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<GoalUpdater>("GoalUpdater");
});
const NodeLibrary longer("libnav2_path_longer_on_approach_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<PathLongerOnApproach>("PathLongerOnApproach");
});
const NodeLibrary single("libnav2_single_trigger_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<SingleTrigger>("SingleTrigger");
});

}  // namespace
}  // namespace nav2_behavior_tree
