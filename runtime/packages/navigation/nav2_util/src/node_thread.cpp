// See node_thread.hpp. Apart from the other sources: a program that refers to threads is linked
// with them.
#include "nav2_util/node_thread.hpp"

#include <chrono>
#include <utility>

namespace nav2_util {

NodeThread::NodeThread(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base)
    : node_(std::move(node_base)),
      executor_(std::make_shared<rclcpp::executors::SingleThreadedExecutor>()) {
  executor_->add_node(node_);
  thread_ = std::make_unique<std::thread>([this] { spin(); });
}

NodeThread::NodeThread(rclcpp::executors::SingleThreadedExecutor::SharedPtr executor)
    : executor_(std::move(executor)) {
  thread_ = std::make_unique<std::thread>([this] { spin(); });
}

NodeThread::~NodeThread() {
  // A call before the thread spins has no effect, as in rclcpp: the thread may be about to start.
  while (!is_over_) {
    executor_->cancel();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  thread_->join();
}

void NodeThread::spin() {
  executor_->spin();
  if (node_) executor_->remove_node(node_);
  is_over_ = true;
}

}  // namespace nav2_util
