// Nodes that plan, smooth and follow paths, and that navigate as a whole.
#include <string>

#include "nav2_msgs/action/compute_path_through_poses.hpp"
#include "nav2_msgs/action/compute_path_to_pose.hpp"
#include "nav2_msgs/action/follow_path.hpp"
#include "nav2_msgs/action/navigate_through_poses.hpp"
#include "nav2_msgs/action/navigate_to_pose.hpp"
#include "nav2_msgs/action/smooth_path.hpp"
#include "nodes/error_code_action.hpp"
#include "nodes/registration.hpp"
#include "nodes/tree_state.hpp"

namespace nav2_behavior_tree {
namespace {

using BT::InputPort;
using BT::OutputPort;
using geometry_msgs::msg::PoseStamped;
using nav_msgs::msg::Path;

/// Writes the path, which is empty when there is none.
template <typename ActionT>
class PlanningAction : public ErrorCodeAction<ActionT> {
  using Base = ErrorCodeAction<ActionT>;

 public:
  using Base::Base;

  static BT::PortsList planning_ports(BT::PortsList ports) {
    ports.insert(InputPort<PoseStamped>("start", "Start in place of the robot's pose"));
    ports.insert(InputPort<std::string>("planner_id", "", "Name of the planner"));
    ports.insert(OutputPort<Path>("path", "The path"));
    return Base::ports_and_code(ports);
  }

  BT::NodeStatus on_success() override {
    this->setOutput("path", this->result_.result->path);
    return Base::on_success();
  }
  BT::NodeStatus on_aborted() override {
    this->setOutput("path", Path());
    return Base::on_aborted();
  }
  BT::NodeStatus on_cancelled() override {
    this->setOutput("path", Path());
    return Base::on_cancelled();
  }
};

class ComputePathToPose : public PlanningAction<nav2_msgs::action::ComputePathToPose> {
 public:
  using PlanningAction::PlanningAction;

  static BT::PortsList providedPorts() {
    return planning_ports({InputPort<PoseStamped>("goal", "Where the path ends"),
                           InputPort<bool>("use_start", "False ignores `start`")});
  }

  void on_tick() override {
    getInput("goal", goal_.goal);
    getInput("planner_id", goal_.planner_id);
    bool is_wanted = true;
    const bool is_said = static_cast<bool>(getInput("use_start", is_wanted));
    goal_.use_start = is_wanted && getInput("start", goal_.start);
    if (is_said && is_wanted && !goal_.use_start) {
      RCLCPP_ERROR(node_->get_logger(),
                   "use_start is set to true but no start pose was provided, falling back to "
                   "default behavior, i.e. using the current robot pose");
    }
  }

  /// A path of before must not be followed.
  void halt() override {
    setOutput("path", Path());
    PlanningAction::halt();
  }
};

class ComputePathThroughPoses : public PlanningAction<nav2_msgs::action::ComputePathThroughPoses> {
 public:
  using PlanningAction::PlanningAction;

  static BT::PortsList providedPorts() {
    return planning_ports({InputPort<Goals>("goals", "Where the path leads through")});
  }

  void on_tick() override {
    getInput("goals", goal_.goals);
    getInput("planner_id", goal_.planner_id);
    if (getInput("start", goal_.start)) goal_.use_start = true;
  }
};

class FollowPath : public ErrorCodeAction<nav2_msgs::action::FollowPath> {
 public:
  using ErrorCodeAction::ErrorCodeAction;

  static BT::PortsList providedPorts() {
    return ports_and_code({InputPort<Path>("path", "Path to follow"),
                           InputPort<std::string>("controller_id", ""),
                           InputPort<std::string>("goal_checker_id", ""),
                           InputPort<std::string>("progress_checker_id", "")});
  }

  void on_tick() override {
    getInput("path", goal_.path);
    for (const auto& [port, value] : names()) getInput(port, *value);
  }

  /// A new path, or another plugin, is followed from now on.
  void on_wait_for_result(
      std::shared_ptr<const nav2_msgs::action::FollowPath::Feedback> /*feedback*/) override {
    Path path;
    getInput("path", path);
    if (path != goal_.path && path != Path()) {
      goal_.path = path;
      goal_updated_ = true;
    }
    for (const auto& [port, value] : names()) {
      std::string name;
      getInput(port, name);
      if (name == *value) continue;
      *value = name;
      goal_updated_ = true;
    }
  }

 private:
  std::vector<std::pair<const char*, std::string*>> names() {
    return {{"controller_id", &goal_.controller_id},
            {"goal_checker_id", &goal_.goal_checker_id},
            {"progress_checker_id", &goal_.progress_checker_id}};
  }
};

class SmoothPath : public ErrorCodeAction<nav2_msgs::action::SmoothPath> {
 public:
  using ErrorCodeAction::ErrorCodeAction;

  static BT::PortsList providedPorts() {
    return ports_and_code(
        {InputPort<Path>("unsmoothed_path", "Path to smooth"),
         InputPort<double>("max_smoothing_duration", 3.0, "Seconds it may take"),
         InputPort<bool>("check_for_collisions", false, "Whether the result is checked"),
         InputPort<std::string>("smoother_id", ""),
         OutputPort<Path>("smoothed_path", "The smoothed path"),
         OutputPort<double>("smoothing_duration", "Seconds it took"),
         OutputPort<bool>("was_completed", "False when its time was over")});
  }

  void on_tick() override {
    getInput("unsmoothed_path", goal_.path);
    getInput("smoother_id", goal_.smoother_id);
    double seconds = 0.0;
    getInput("max_smoothing_duration", seconds);
    goal_.max_smoothing_duration = rclcpp::Duration::from_seconds(seconds);
    getInput("check_for_collisions", goal_.check_for_collisions);
  }

  BT::NodeStatus on_success() override {
    setOutput("smoothed_path", result_.result->path);
    setOutput("smoothing_duration", rclcpp::Duration(result_.result->smoothing_duration).seconds());
    setOutput("was_completed", static_cast<bool>(result_.result->was_completed));
    return ErrorCodeAction::on_success();
  }
};

/// A whole navigation, led by a tree of its own.
template <typename ActionT>
class NavigateAction : public ErrorCodeAction<ActionT> {
 public:
  using ErrorCodeAction<ActionT>::ErrorCodeAction;

 protected:
  template <typename ValueT>
  void take(const char* port, ValueT& value, const char* node_name) {
    if (!this->getInput(port, value)) {
      RCLCPP_ERROR(this->node_->get_logger(), "%s: goal not provided", node_name);
      return;
    }
    this->getInput("behavior_tree", this->goal_.behavior_tree);
  }
};

class NavigateToPose : public NavigateAction<nav2_msgs::action::NavigateToPose> {
 public:
  using NavigateAction::NavigateAction;

  static BT::PortsList providedPorts() {
    return ports_and_code({InputPort<PoseStamped>("goal", "Where to go"),
                           InputPort<std::string>("behavior_tree", "File of the tree")});
  }
  void on_tick() override { take("goal", goal_.pose, "NavigateToPoseAction"); }
};

class NavigateThroughPoses : public NavigateAction<nav2_msgs::action::NavigateThroughPoses> {
 public:
  using NavigateAction::NavigateAction;

  static BT::PortsList providedPorts() {
    return ports_and_code({InputPort<Goals>("goals", "Where to go through"),
                           InputPort<std::string>("behavior_tree", "File of the tree")});
  }
  void on_tick() override { take("goals", goal_.poses, "NavigateThroughPosesAction"); }
};

const NodeLibrary to_pose("libnav2_compute_path_to_pose_action_bt_node.so", [](Factory& factory) {
  register_client<ComputePathToPose>(factory, "ComputePathToPose", "compute_path_to_pose");
});
const NodeLibrary through_poses("libnav2_compute_path_through_poses_action_bt_node.so",
                                [](Factory& factory) {
                                  register_client<ComputePathThroughPoses>(
                                      factory, "ComputePathThroughPoses",
                                      "compute_path_through_poses");
                                });
const NodeLibrary follow("libnav2_follow_path_action_bt_node.so", [](Factory& factory) {
  register_client<FollowPath>(factory, "FollowPath", "follow_path");
});
const NodeLibrary smooth("libnav2_smooth_path_action_bt_node.so", [](Factory& factory) {
  register_client<SmoothPath>(factory, "SmoothPath", "smooth_path");
});
const NodeLibrary navigate("libnav2_navigate_to_pose_action_bt_node.so", [](Factory& factory) {
  register_client<NavigateToPose>(factory, "NavigateToPose", "navigate_to_pose");
});
const NodeLibrary navigate_through("libnav2_navigate_through_poses_action_bt_node.so",
                                   [](Factory& factory) {
                                     register_client<NavigateThroughPoses>(
                                         factory, "NavigateThroughPoses", "navigate_through_poses");
                                   });

}  // namespace
}  // namespace nav2_behavior_tree
