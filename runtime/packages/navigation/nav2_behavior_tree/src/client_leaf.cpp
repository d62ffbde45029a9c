// See client_leaf.hpp.
#include "nav2_behavior_tree/detail/client_leaf.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace nav2_behavior_tree {
namespace detail {

std::chrono::milliseconds timeout_of(const BT::TreeNode& node, const char* name) {
  std::chrono::milliseconds timeout{0};
  BT::getInputPortOrBlackboard(node, *node.config().blackboard, name, timeout);
  return std::max(timeout, kLeastTimeout);
}

ClientLeaf::ClientLeaf(const std::string& name, const BT::NodeConfiguration& conf)
    : BT::ActionNodeBase(name, conf) {
  const BT::Blackboard& blackboard = *config().blackboard;
  node_ = blackboard.get<rclcpp::Node::SharedPtr>("node");
  callback_group_ =
      node_->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  callback_group_executor_.add_callback_group(callback_group_, node_->get_node_base_interface());
  server_timeout_ = timeout_of(*this, "server_timeout");
  wait_for_service_timeout_ = blackboard.get<Milliseconds>("wait_for_service_timeout");
  max_timeout_ = blackboard.get<Milliseconds>("bt_loop_duration") / 2;
}

void ClientLeaf::increment_recovery_count() {
  int count = 0;
  config().blackboard->get("number_recoveries", count);
  config().blackboard->set("number_recoveries", count + 1);
}

void ClientLeaf::require_server(bool is_there, std::string kind, const std::string& name) const {
  if (is_there) return;
  RCLCPP_ERROR(node_->get_logger(), "\"%s\" %s server not available after waiting for %.2fs",
               name.c_str(), kind.c_str(),
               std::chrono::duration<double>(wait_for_service_timeout_).count());
  kind.front() = static_cast<char>(std::toupper(kind.front()));
  throw std::runtime_error(kind + " server " + name + " not available");
}

}  // namespace detail
}  // namespace nav2_behavior_tree
