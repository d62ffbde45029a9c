// The node of a container whose components do not wait for each other: each has an executor of its
// own, in a thread of its own.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <thread>

#include "rclcpp_components/component_manager.hpp"

namespace rclcpp_components {

template <typename ExecutorT = rclcpp::executors::SingleThreadedExecutor>
class ComponentManagerIsolated : public rclcpp_components::ComponentManager {
 public:
  using rclcpp_components::ComponentManager::ComponentManager;

  ~ComponentManagerIsolated() override {
    for (auto& [id, dedicated] : dedicated_) stop(dedicated);
    node_wrappers_.clear();
  }

 protected:
  void add_node_to_executor(uint64_t node_id) override {
    const auto executor = std::make_shared<ExecutorT>();
    executor->add_node(node_wrappers_.at(node_id).get_node_base_interface());
    dedicated_[node_id] = {executor, std::thread([executor] { executor->spin(); })};
  }

  void remove_node_from_executor(uint64_t node_id) override {
    const auto found = dedicated_.find(node_id);
    if (found == dedicated_.end()) return;
    stop(found->second);
    dedicated_.erase(found);
  }

 private:
  struct Dedicated {
    std::shared_ptr<rclcpp::Executor> executor;
    std::thread thread;
  };

  void stop(Dedicated& dedicated) {
    // A thread that has not begun to spin would not see the end of it.
    while (!dedicated.executor->is_spinning() &&
           get_node_base_interface()->get_context()->is_valid()) {
      std::this_thread::yield();
    }
    dedicated.executor->cancel();
    if (dedicated.thread.joinable()) dedicated.thread.join();
  }

  std::map<uint64_t, Dedicated> dedicated_;
};

}  // namespace rclcpp_components
