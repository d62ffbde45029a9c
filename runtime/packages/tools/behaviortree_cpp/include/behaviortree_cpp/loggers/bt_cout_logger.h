// Prints each change of a tree's nodes.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

#include "behaviortree_cpp/loggers/abstract_logger.h"

namespace BT {

class StdCoutLogger : public StatusChangeLogger {
 public:
  explicit StdCoutLogger(const Tree& tree) : StatusChangeLogger(tree.rootNode()) {}

  void callback(Duration timestamp, const TreeNode& node, NodeStatus before,
                NodeStatus status) override {
    constexpr int kNameWidth = 24;
    std::printf("[%.3f]: %-*s %s -> %s\n", std::chrono::duration<double>(timestamp).count(),
                kNameWidth, node.name().c_str(), toStr(before, true).c_str(),
                toStr(status, true).c_str());
    flush();
  }
  void flush() override { std::fflush(stdout); }
};

}  // namespace BT
