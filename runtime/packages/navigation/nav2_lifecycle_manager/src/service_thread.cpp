// The manager with a thread. Apart: a program that refers to threads is linked with them.
#include <memory>

#include "nav2_lifecycle_manager/lifecycle_manager.hpp"
#include "nav2_util/node_thread.hpp"

namespace nav2_lifecycle_manager {
namespace {

std::shared_ptr<void> start_thread(rclcpp::executors::SingleThreadedExecutor::SharedPtr executor) {
  return std::make_shared<nav2_util::NodeThread>(executor);
}

}  // namespace

LifecycleManager::LifecycleManager(const rclcpp::NodeOptions& options)
    : LifecycleManager(options, start_thread) {}

}  // namespace nav2_lifecycle_manager
