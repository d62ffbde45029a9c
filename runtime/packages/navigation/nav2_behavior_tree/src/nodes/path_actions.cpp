// Nodes that change paths and goals, or find poses.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "nav2_behavior_tree/bt_utils.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/robot_utils.hpp"
#include "nodes/registration.hpp"
#include "nodes/tree_state.hpp"
#include "tf2/LinearMath/Quaternion.h"

namespace nav2_behavior_tree {
namespace {

using BT::InputPort;
using BT::NodeStatus;
using BT::OutputPort;
using geometry_msgs::msg::PoseStamped;
using nav2_util::geometry_utils::euclidean_distance;
using nav_msgs::msg::Path;

/// Is done within one tick.
class QuickAction : public BT::ActionNodeBase {
 public:
  using BT::ActionNodeBase::ActionNodeBase;
  void halt() override {}

 protected:
  double number(const char* port) const {
    double value = 0.0;
    getInput(port, value);
    return value;
  }
  rclcpp::Logger logger() const { return ros_node_of(*this)->get_logger(); }
};

class RemovePassedGoals : public QuickAction {
 public:
  RemovePassedGoals(const std::string& name, const BT::NodeConfiguration& conf)
      : QuickAction(name, conf), robot_(*this) {}

  static BT::PortsList providedPorts() {
    return RobotPlace::ports(
        {InputPort<Goals>("input_goals", "All goals"),
         OutputPort<Goals>("output_goals", "The goals that are ahead"),
         InputPort<double>("radius", 0.5, "Distance at which it is passed [m]")});
  }

  /// The last goal always stays.
  NodeStatus tick() override {
    Goals goals;
    getInput("input_goals", goals);
    if (!goals.empty()) {
      PoseStamped pose;
      if (!robot_.find(pose, goals.front().header.frame_id)) return NodeStatus::FAILURE;
      const double radius = number("radius");
      size_t passed = 0;
      while (passed + 1 < goals.size() && euclidean_distance(goals[passed], pose) <= radius) {
        ++passed;
      }
      goals.erase(goals.begin(), goals.begin() + static_cast<std::ptrdiff_t>(passed));
    }
    setOutput("output_goals", goals);
    return NodeStatus::SUCCESS;
  }

 private:
  RobotPlace robot_;
};

/// Takes the end of a path off, and turns its last pose towards where the path led.
class TruncatePath : public QuickAction {
 public:
  using QuickAction::QuickAction;

  static BT::PortsList providedPorts() {
    return {InputPort<Path>("input_path", "The whole path"),
            OutputPort<Path>("output_path", "The path without its end"),
            InputPort<double>("distance", 1.0, "Distance from the end [m]")};
  }

  NodeStatus tick() override {
    Path path;
    getInput("input_path", path);
    if (!path.poses.empty()) {
      const double distance = number("distance");
      const auto end = path.poses.back().pose.position;
      while (path.poses.size() > 2 &&
             euclidean_distance(path.poses.back().pose.position, end) < distance) {
        path.poses.pop_back();
      }
      auto& last = path.poses.back().pose;
      last.orientation = nav2_util::geometry_utils::orientationAroundZAxis(
          direction(end.x - last.position.x, end.y - last.position.y));
    }
    setOutput("output_path", path);
    return NodeStatus::SUCCESS;
  }

 private:
  double direction(double x, double y) const {
    const double angle = std::atan2(y, x);
    if (std::isfinite(angle)) return angle;
    RCLCPP_WARN(logger(), "Final angle is not valid while truncating path. Setting to 0.0");
    return 0.0;
  }
};

/// The part of a path around the robot.
class TruncatePathLocal : public QuickAction {
  using Poses = std::vector<PoseStamped>;

 public:
  TruncatePathLocal(const std::string& name, const BT::NodeConfiguration& conf)
      : QuickAction(name, conf),
        buffer_(conf.blackboard->get<std::shared_ptr<tf2_ros::Buffer>>("tf_buffer")) {}

  static BT::PortsList providedPorts() {
    return {InputPort<Path>("input_path", "The whole path"),
            OutputPort<Path>("output_path", "The part around the robot"),
            InputPort<double>("distance_forward", 8.0, "Length ahead [m]"),
            InputPort<double>("distance_backward", 4.0, "Length behind [m]"),
            InputPort<std::string>("robot_frame", "base_link", "Frame of the robot"),
            InputPort<double>("transform_tolerance", 0.2, "Wait for the robot's pose [s]"),
            InputPort<PoseStamped>("pose", "Pose in place of the robot's"),
            InputPort<double>("angular_distance_weight", 0.0,
                              "Metres for a radian, when the nearest pose is looked for"),
            InputPort<double>("max_robot_pose_search_dist", std::numeric_limits<double>::infinity(),
                              "Length from the last nearest pose that is searched [m]")};
  }

  NodeStatus tick() override {
    using nav2_util::geometry_utils::first_after_integrated_distance;
    using nav2_util::geometry_utils::min_by;
    Path path;
    getInput("input_path", path);
    const double search = number("max_robot_pose_search_dist");
    const bool is_pruned = std::isfinite(search);
    if (!is_pruned || path != path_) {
      path_ = path;
      begin_ = 0;
    }
    PoseStamped pose;
    if (!find_robot(pose)) return NodeStatus::FAILURE;
    if (path_.poses.empty()) {
      setOutput("output_path", path_);
      return NodeStatus::SUCCESS;
    }
    const Poses& poses = path_.poses;
    const auto begin = poses.begin() + static_cast<std::ptrdiff_t>(begin_);
    const auto end =
        is_pruned ? first_after_integrated_distance(begin, poses.end(), search) : poses.end();
    const double weight = number("angular_distance_weight");
    const auto nearest =
        min_by(begin, end, [&](const PoseStamped& one) { return distance(pose, one, weight); });
    if (is_pruned) begin_ = static_cast<size_t>(nearest - poses.begin());
    const auto forward =
        first_after_integrated_distance(nearest, poses.end(), number("distance_forward"));
    const auto backward = first_after_integrated_distance(
        std::reverse_iterator(nearest + 1), poses.rend(), number("distance_backward"));
    Path part;
    part.header = path_.header;
    part.poses.assign(backward.base(), forward);
    setOutput("output_path", part);
    return NodeStatus::SUCCESS;
  }

 private:
  bool find_robot(PoseStamped& pose) const {
    if (getInput("pose", pose)) return true;
    std::string frame;
    if (!getInput("robot_frame", frame)) {
      RCLCPP_ERROR(logger(), "Neither pose nor robot_frame specified for %s", name().c_str());
      return false;
    }
    if (nav2_util::getCurrentPose(pose, *buffer_, path_.header.frame_id, frame,
                                  number("transform_tolerance"))) {
      return true;
    }
    RCLCPP_WARN(logger(), "Failed to lookup current robot pose for %s", name().c_str());
    return false;
  }

  static double distance(const PoseStamped& left, const PoseStamped& right, double weight) {
    tf2::Quaternion from;
    tf2::Quaternion to;
    tf2::fromMsg(left.pose.orientation, from);
    tf2::fromMsg(right.pose.orientation, to);
    const double angle = weight == 0.0 ? 0.0 : weight * std::abs(from.angleShortestPath(to));
    return std::hypot(euclidean_distance(left, right), angle);
  }

  std::shared_ptr<tf2_ros::Buffer> buffer_;
  Path path_;
  size_t begin_ = 0;  ///< where the search begins
};

class ConcatenatePaths : public QuickAction {
 public:
  using QuickAction::QuickAction;

  static BT::PortsList providedPorts() {
    return {InputPort<Path>("input_path1", "The first path"),
            InputPort<Path>("input_path2", "The path after it"),
            OutputPort<Path>("output_path", "Both")};
  }

  NodeStatus tick() override {
    Path path;
    Path second;
    getInput("input_path1", path);
    getInput("input_path2", second);
    if (path.poses.empty() && second.poses.empty()) {
      RCLCPP_ERROR(logger(), "No input paths provided to concatenate. Both paths are empty.");
      return NodeStatus::FAILURE;
    }
    if (path.header == std_msgs::msg::Header()) path.header = second.header;
    path.poses.insert(path.poses.end(), second.poses.begin(), second.poses.end());
    setOutput("output_path", path);
    return NodeStatus::SUCCESS;
  }
};

class GetPoseFromPath : public QuickAction {
 public:
  using QuickAction::QuickAction;

  static BT::PortsList providedPorts() {
    return {InputPort<Path>("path", "Path with the pose"),
            OutputPort<PoseStamped>("pose", "The pose"),
            InputPort<int>("index", 0, "Index of the pose; below 0 it counts from the end")};
  }

  NodeStatus tick() override {
    Path path;
    int index = 0;
    getInput("path", path);
    getInput("index", index);
    const auto count = static_cast<int>(path.poses.size());
    if (index < 0) index += count;
    if (index < 0 || index >= count) return NodeStatus::FAILURE;
    PoseStamped pose = path.poses[static_cast<size_t>(index)];
    if (pose.header.frame_id.empty()) pose.header.frame_id = path.header.frame_id;
    setOutput("pose", pose);
    return NodeStatus::SUCCESS;
  }
};

class GetCurrentPose : public QuickAction {
 public:
  GetCurrentPose(const std::string& name, const BT::NodeConfiguration& conf)
      : QuickAction(name, conf), robot_(*this) {}

  static BT::PortsList providedPorts() {
    return RobotPlace::ports({OutputPort<PoseStamped>("current_pose", "Where the robot is")});
  }

  NodeStatus tick() override {
    PoseStamped pose;
    if (!robot_.find(pose)) {
      RCLCPP_WARN(logger(), "Current robot pose is not available.");
      return NodeStatus::FAILURE;
    }
    setOutput("current_pose", pose);
    return NodeStatus::SUCCESS;
  }

 private:
  RobotPlace robot_;
};

const NodeLibrary remove_passed("libnav2_remove_passed_goals_action_bt_node.so",
                                [](Factory& factory) {
                                  factory.registerNodeType<RemovePassedGoals>("RemovePassedGoals");
                                });
const NodeLibrary truncate("libnav2_truncate_path_action_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<TruncatePath>("TruncatePath");
});
const NodeLibrary truncate_local("libnav2_truncate_path_local_action_bt_node.so",
                                 [](Factory& factory) {
                                   factory.registerNodeType<TruncatePathLocal>("TruncatePathLocal");
                                 });
const NodeLibrary concatenate("libnav2_concatenate_paths_action_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<ConcatenatePaths>("ConcatenatePaths");
});
const NodeLibrary pose_from_path("libnav2_get_pose_from_path_action_bt_node.so",
                                 [](Factory& factory) {
                                   factory.registerNodeType<GetPoseFromPath>("GetPoseFromPath");
                                 });
const NodeLibrary current_pose("libnav2_get_current_pose_action_bt_node.so", [](Factory& factory) {
  factory.registerNodeType<GetCurrentPose>("GetCurrentPose");
});

}  // namespace
}  // namespace nav2_behavior_tree
