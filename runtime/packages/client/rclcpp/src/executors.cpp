// The single-threaded executor and the free functions. (The multi-threaded one has its own file,
// so that only programs that use it are linked with threads.)
#include "rclcpp/executors.hpp"

#include <stdexcept>

namespace rclcpp {
namespace {

rclcpp::ExecutorOptions options_for(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr& node) {
  rclcpp::ExecutorOptions options;
  options.context = node->get_context();
  return options;
}

}  // namespace

void executors::SingleThreadedExecutor::spin() {
  if (spinning.exchange(true)) {
    throw std::runtime_error("spin() called while already spinning");
  }
  struct Reset {
    std::atomic_bool& flag;
    ~Reset() { flag = false; }
  } reset{spinning};
  while (rclcpp::ok(context_) && spinning) {
    rclcpp::AnyExecutable any_executable;
    if (get_next_executable(any_executable)) {
      execute_any_executable(any_executable);
    }
  }
}

void spin_all(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_ptr,
              std::chrono::nanoseconds max_duration) {
  rclcpp::executors::SingleThreadedExecutor executor(options_for(node_ptr));
  executor.spin_node_all(node_ptr, max_duration);
}

void spin_all(rclcpp::Node::SharedPtr node_ptr, std::chrono::nanoseconds max_duration) {
  rclcpp::spin_all(node_ptr->get_node_base_interface(), max_duration);
}

void spin_some(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_ptr) {
  rclcpp::executors::SingleThreadedExecutor executor(options_for(node_ptr));
  executor.spin_node_some(node_ptr);
}

void spin_some(rclcpp::Node::SharedPtr node_ptr) {
  rclcpp::spin_some(node_ptr->get_node_base_interface());
}

void spin(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_ptr) {
  rclcpp::executors::SingleThreadedExecutor executor(options_for(node_ptr));
  executor.add_node(node_ptr);
  executor.spin();
  executor.remove_node(node_ptr);
}

void spin(rclcpp::Node::SharedPtr node_ptr) {
  rclcpp::spin(node_ptr->get_node_base_interface());
}

}  // namespace rclcpp
