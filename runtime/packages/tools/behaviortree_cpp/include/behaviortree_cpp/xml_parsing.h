// Trees are read by the factory; this name is where user code expects that.
#pragma once

#include "behaviortree_cpp/bt_factory.h"

namespace BT {

/// The nodes that a factory knows, with their ports, as XML for editors of trees.
[[nodiscard]] std::string writeTreeNodesModelXML(const BehaviorTreeFactory& factory,
                                                 bool include_builtin = false);

}  // namespace BT
