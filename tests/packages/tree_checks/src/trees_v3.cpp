// A tree from a package's share folder, with nodes from libraries, by the names of version 3.

// Compatibility, works: behaviortree_cpp_v3 and behaviortree_cpp: trees in XML of versions 3 and 4, classes of nodes with ports,
// builders, simple actions, conditions and decorators, blackboards, subtrees, the control nodes and decorators of both versions,
// `StdCoutLogger`, libraries of nodes (`BT_REGISTER_NODES`, `registerFromPlugin`) that the program links or whose package it names

// Compatibility, differs: behavior trees -> scripts (`Script`, `_skipIf`), coroutines (`CoroActionNode`) and the loggers to files are
// missing; Groot is told nothing, as a browser has no sockets; a wait is looked at when the tree is ticked; a tree with
// `ThreadedAction` needs a page with shared memory

#include <string>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "behaviortree_cpp_v3/behavior_tree.h"
#include "behaviortree_cpp_v3/bt_factory.h"
#include "behaviortree_cpp_v3/loggers/bt_zmq_publisher.h"
#include "behaviortree_cpp_v3/utils/shared_library.h"
#include "checks.hpp"

namespace {

class Wait : public BT::StatefulActionNode {
 public:
  using BT::StatefulActionNode::StatefulActionNode;
  static BT::PortsList providedPorts() { return {}; }
  BT::NodeStatus onStart() override { return BT::NodeStatus::RUNNING; }
  BT::NodeStatus onRunning() override { return BT::NodeStatus::SUCCESS; }
  void onHalted() override { ++halted; }

  static inline int halted = 0;
};

}  // namespace

int main(int argc, char* argv[]) {
  rclcpp::init(argc, argv);
  Checks checks("trees_v3");
  auto node = rclcpp::Node::make_shared("patrol");
  BT::BehaviorTreeFactory factory;
  BT::SharedLibrary loader;
  factory.registerFromPlugin(loader.getOSName("say_bt_node"));
  factory.registerFromPlugin("/opt/some/lib/" + loader.getOSName("tree_counter_bt_node"));
  CHECK_THROWS(BT::RuntimeError, factory.registerFromPlugin(loader.getOSName("nobody")));
  factory.registerNodeType<Wait>("Wait");
  factory.registerSimpleCondition(
      "IsCharged",
      [](BT::TreeNode& self) {
        return self.getInput<int>("level").value_or(0) > 50 ? BT::NodeStatus::SUCCESS
                                                            : BT::NodeStatus::FAILURE;
      },
      {BT::InputPort<int>("level")});
  factory.registerSimpleAction(
      "Enough",
      [](BT::TreeNode& self) {
        int rounds = 0;
        if (!self.getInput("rounds", rounds)) throw BT::RuntimeError("no rounds");
        return rounds >= 3 ? BT::NodeStatus::SUCCESS : BT::NodeStatus::FAILURE;
      },
      {BT::InputPort<int>("rounds")});

  auto blackboard = BT::Blackboard::create();
  blackboard->set("node", node);
  const std::string folder = ament_index_cpp::get_package_share_directory("tree_checks");
  BT::Tree tree = factory.createTreeFromFile(folder + "/trees/patrol.xml", blackboard);
  const BT::PublisherZMQ groot(tree, 10, 1666, 1667);
  CHECK(tree.rootNode()->name() == "KeepRunningUntilFailure" && tree.rootBlackboard() == blackboard);
  CHECK(tree.tickRoot() == BT::NodeStatus::RUNNING);
  CHECK(blackboard->get<int>("charge") == 100 && blackboard->get<int>("rounds") == 1);
  CHECK(tree.tickRoot() == BT::NodeStatus::RUNNING && Wait::halted == 2);
  rclcpp::Rate rate(100);
  BT::NodeStatus status = BT::NodeStatus::RUNNING;
  while (rclcpp::ok() && status == BT::NodeStatus::RUNNING) {
    status = tree.tickRoot();
    rclcpp::spin_some(node);
    rate.sleep();
  }
  CHECK(status == BT::NodeStatus::FAILURE && blackboard->get<int>("rounds") == 3);
  tree.haltTree();
  CHECK(tree.rootNode()->status() == BT::NodeStatus::IDLE);
  return checks.finish();
}
