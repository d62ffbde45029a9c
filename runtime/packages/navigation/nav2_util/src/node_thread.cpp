// See node_thread.hpp. Apart from the other sources: a program that refers to threads is linked
// with them.
#include "nav2_util/node_thread.hpp"

#include <utility>

namespace nav2_util {

NodeThread::NodeThread(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base)
    : node_(std::move(node_base)),
      executor_(std::make_shared<rclcpp::executors::SingleThreadedExecutor>()) {
  executor_->add_node(node_);
  thread_ = std::make_unique<std::thread>([this] {
    executor_->spin();
    executor_->remove_node(node_);
  });
}

NodeThread::NodeThread(rclcpp::executors::SingleThreadedExecutor::SharedPtr executor)
    : executor_(std::move(executor)) {
  thread_ = std::make_unique<std::thread>([this] { executor_->spin(); });
}

NodeThread::~NodeThread() {
  executor_->cancel();
  thread_->join();
}

}  // namespace nav2_util
