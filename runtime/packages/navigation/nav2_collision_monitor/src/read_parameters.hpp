// Parameters of zones and sources. They throw what makes a configuration fail.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>

#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"

namespace nav2_collision_monitor {

using NodePtr = nav2_util::LifecycleNode::SharedPtr;

inline NodePtr locked(const nav2_util::LifecycleNode::WeakPtr& node) {
  NodePtr strong = node.lock();
  if (!strong) throw std::runtime_error{"Failed to lock node"};
  return strong;
}

template <typename T>
T read(const NodePtr& node, const std::string& name, const T& default_value) {
  nav2_util::declare_parameter_if_not_declared(node, name, rclcpp::ParameterValue(default_value));
  return node->get_parameter(name).get_value<T>();
}

/// Throws when nothing sets it.
template <typename T>
T read_required(const NodePtr& node, const std::string& name, rclcpp::ParameterType type) {
  nav2_util::declare_parameter_if_not_declared(node, name, type);
  return node->get_parameter(name).get_value<T>();
}

/// Throws for a number outside of the range, and for one that is not a number.
inline double read_number(const NodePtr& node, const std::string& name, double default_value,
                          double least, double most = 1e9) {
  const double value = read<double>(node, name, default_value);
  if (value >= least && value <= most) return value;
  char range[80];
  std::snprintf(range, sizeof(range), "%g to %g, and is %g", least, most, value);
  throw std::runtime_error("parameter '" + name + "' has to be a number from " + range);
}

}  // namespace nav2_collision_monitor
