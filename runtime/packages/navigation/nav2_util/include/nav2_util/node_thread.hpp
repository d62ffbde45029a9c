// A thread that spins a node or an executor. A program that has one is linked with threads.
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "rclcpp/rclcpp.hpp"

namespace nav2_util {

class NodeThread {
 public:
  explicit NodeThread(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base);
  explicit NodeThread(rclcpp::executors::SingleThreadedExecutor::SharedPtr executor);
  template <typename NodeT>
  explicit NodeThread(NodeT node) : NodeThread(node->get_node_base_interface()) {}
  /// Cancels the executor and waits for the thread.
  ~NodeThread();

 protected:
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::unique_ptr<std::thread> thread_;
  rclcpp::Executor::SharedPtr executor_;

 private:
  void spin();

  std::atomic<bool> is_over_{false};
};

}  // namespace nav2_util
