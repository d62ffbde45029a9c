// How nodes come into the factory: under the name of the library that upstream has for them.
#pragma once

#include <memory>
#include <string>

#include "behaviortree_cpp/bt_factory.h"

namespace nav2_behavior_tree {

/// One in each source for each library: `const NodeLibrary spin("libnav2_....so", [](auto& f)
/// ...)`.
using NodeLibrary = BT::impl::PluginRegistration;
using Factory = BT::BehaviorTreeFactory;

/// A node that talks to a server, which has this name unless the tree says another.
template <typename NodeT>
void register_client(Factory& factory, const char* id, const char* server) {
  factory.registerBuilder<NodeT>(
      id, [server](const std::string& name, const BT::NodeConfiguration& config) {
        return std::make_unique<NodeT>(name, server, config);
      });
}

}  // namespace nav2_behavior_tree
