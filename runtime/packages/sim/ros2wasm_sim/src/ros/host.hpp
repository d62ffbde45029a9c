// The ROS side of the simulator: nodes of plugins, stamps, and what is said to people.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "builtin_interfaces/msg/time.hpp"
#include "core/simulation.hpp"
#include "plugins/parameters.hpp"
#include "rclcpp/rclcpp.hpp"

namespace ros2wasm_sim {

inline builtin_interfaces::msg::Time stamp_of(std::int64_t time_ns) {
  builtin_interfaces::msg::Time stamp;
  stamp.sec = static_cast<std::int32_t>(time_ns / 1'000'000'000);
  stamp.nanosec = static_cast<std::uint32_t>(time_ns % 1'000'000'000);
  return stamp;
}

class Host {
 public:
  /// `node` is that of the server.
  Host(rclcpp::Node::SharedPtr node, rclcpp::Executor::SharedPtr executor, std::uint64_t seed);

  const rclcpp::Node::SharedPtr& node() const { return node_; }
  /// Runs all nodes of the program, in its only thread.
  const rclcpp::Executor::SharedPtr& executor() const { return executor_; }
  std::uint64_t seed() const { return seed_; }

  /// The node of a plugin of Gazebo Classic, with the namespace, remappings and parameters of its
  /// <ros> element. Throws std::runtime_error when there is one of this full name.
  rclcpp::Node::SharedPtr add_plugin_node(const Plugin& plugin);
  void remove_node(const rclcpp::Node::SharedPtr& node);

 private:
  rclcpp::Node::SharedPtr node_;
  rclcpp::Executor::SharedPtr executor_;
  std::uint64_t seed_;
  std::vector<std::string> names_;
};

/// The node of a Classic plugin for as long as the plugin lives.
class PluginNode {
 public:
  PluginNode(Host& host, const Plugin& plugin) : host_(host), node_(host.add_plugin_node(plugin)) {}
  ~PluginNode() { host_.remove_node(node_); }
  PluginNode(const PluginNode&) = delete;
  PluginNode& operator=(const PluginNode&) = delete;

  rclcpp::Node* operator->() const { return node_.get(); }
  const rclcpp::Node::SharedPtr& get() const { return node_; }

 private:
  Host& host_;
  rclcpp::Node::SharedPtr node_;
};

}  // namespace ros2wasm_sim
