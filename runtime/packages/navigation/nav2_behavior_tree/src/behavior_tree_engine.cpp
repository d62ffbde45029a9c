// See behavior_tree_engine.hpp.
#include "nav2_behavior_tree/behavior_tree_engine.hpp"

#include <set>
#include <utility>

#include "behaviortree_cpp/utils/shared_library.h"
#include "nav2_behavior_tree/json_utils.hpp"

namespace nav2_behavior_tree {

BehaviorTreeEngine::BehaviorTreeEngine(const std::vector<std::string>& plugin_libraries,
                                       rclcpp::Node::SharedPtr node)
    : clock_(node->get_clock()) {
  std::set<std::string> registered;
  for (const std::string& name : plugin_libraries) {
    if (registered.insert(name).second) {
      factory_.registerFromPlugin(BT::SharedLibrary::getOSName(name));
    }
  }
  BT::RegisterJsonDefinition<geometry_msgs::msg::PoseStamped>();
  BT::RegisterJsonDefinition<nav_msgs::msg::Path>();
  BT::RegisterJsonDefinition<std::chrono::milliseconds>();
  // More than one child may run in the trees of Nav2.
  BT::ReactiveSequence::EnableException(false);
  BT::ReactiveFallback::EnableException(false);
}

BtStatus BehaviorTreeEngine::run(BT::Tree* tree, std::function<void()> onLoop,
                                 std::function<bool()> cancelRequested,
                                 std::chrono::milliseconds loopTimeout) {
  const auto logger = rclcpp::get_logger("BehaviorTreeEngine");
  rclcpp::WallRate rate(loopTimeout);
  BT::NodeStatus answer = BT::NodeStatus::RUNNING;
  try {
    while (rclcpp::ok() && answer == BT::NodeStatus::RUNNING) {
      if (cancelRequested()) {
        tree->haltTree();
        return BtStatus::CANCELED;
      }
      answer = tree->tickOnce();
      if (!BT::isStatusCompleted(answer)) onLoop();
      if (!rate.sleep()) {
        RCLCPP_DEBUG_THROTTLE(logger, *clock_, 1000, "Behavior Tree tick rate %0.2f was exceeded!",
                              1e9 / static_cast<double>(rate.period().count()));
      }
    }
  } catch (const std::exception& error) {
    RCLCPP_ERROR(logger, "Behavior tree threw exception: %s. Exiting with failure.", error.what());
    return BtStatus::FAILED;
  }
  return answer == BT::NodeStatus::SUCCESS ? BtStatus::SUCCEEDED : BtStatus::FAILED;
}

BT::Tree BehaviorTreeEngine::createTreeFromText(const std::string& xml_string,
                                                BT::Blackboard::Ptr blackboard) {
  return factory_.createTreeFromText(xml_string, std::move(blackboard));
}

BT::Tree BehaviorTreeEngine::createTreeFromFile(const std::string& file_path,
                                                BT::Blackboard::Ptr blackboard) {
  return factory_.createTreeFromFile(file_path, std::move(blackboard));
}

void BehaviorTreeEngine::addGrootMonitoring(BT::Tree* tree, uint16_t server_port) {
  groot_monitor_ = std::make_unique<BT::Groot2Publisher>(*tree, server_port);
}

void BehaviorTreeEngine::resetGrootMonitor() {
  groot_monitor_.reset();
}

void BehaviorTreeEngine::haltAllActions(BT::Tree& tree) {
  tree.haltTree();
}

}  // namespace nav2_behavior_tree
