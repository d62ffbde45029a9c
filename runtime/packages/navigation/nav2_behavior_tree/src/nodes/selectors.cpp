// Nodes that choose a plugin of a server by a topic.
#include <string>

#include "nodes/registration.hpp"
#include "nodes/tree_state.hpp"
#include "std_msgs/msg/string.hpp"

namespace nav2_behavior_tree {
namespace {

/// The last name of the topic, else the default.
class Selector : public BT::SyncActionNode {
 public:
  /// `kind`: "planner"; it is part of the names of ports and of the topic.
  Selector(const std::string& name, const BT::NodeConfiguration& conf, const char* kind)
      : BT::SyncActionNode(name, conf),
        kind_(kind),
        topic_(ros_node_of(*this), topic_name(*this),
               rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable(),
               [this](const std_msgs::msg::String& message) { selected_ = message.data; }) {}

  static BT::PortsList ports(const std::string& kind) {
    return {BT::InputPort<std::string>("default_" + kind, "Chosen before the topic says one"),
            BT::InputPort<std::string>("topic_name", kind + "_selector", "Topic with names"),
            BT::OutputPort<std::string>("selected_" + kind, "The name")};
  }

  BT::NodeStatus tick() override {
    topic_.receive();
    if (selected_.empty()) getInput("default_" + kind_, selected_);
    if (selected_.empty()) return BT::NodeStatus::FAILURE;
    setOutput("selected_" + kind_, selected_);
    return BT::NodeStatus::SUCCESS;
  }

 private:
  static std::string topic_name(const BT::TreeNode& node) {
    std::string name;
    node.getInput("topic_name", name);
    return name;
  }

  std::string kind_;
  std::string selected_;
  TreeTopic<std_msgs::msg::String> topic_;
};

void register_selector(Factory& factory, const char* id, const char* kind) {
  factory.registerNodeType<Selector>(id, Selector::ports(kind), kind);
}

const NodeLibrary planner("libnav2_planner_selector_bt_node.so", [](Factory& factory) {
  register_selector(factory, "PlannerSelector", "planner");
});
const NodeLibrary controller("libnav2_controller_selector_bt_node.so", [](Factory& factory) {
  register_selector(factory, "ControllerSelector", "controller");
});
const NodeLibrary smoother("libnav2_smoother_selector_bt_node.so", [](Factory& factory) {
  register_selector(factory, "SmootherSelector", "smoother");
});
const NodeLibrary goal_checker("libnav2_goal_checker_selector_bt_node.so", [](Factory& factory) {
  register_selector(factory, "GoalCheckerSelector", "goal_checker");
});
const NodeLibrary progress_checker("libnav2_progress_checker_selector_bt_node.so",
                                   [](Factory& factory) {
                                     register_selector(factory, "ProgressCheckerSelector",
                                                       "progress_checker");
                                   });

}  // namespace
}  // namespace nav2_behavior_tree
