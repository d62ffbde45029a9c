// Texts of ports as values, and where a node of a tree finds its settings.
#pragma once

#include <chrono>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "behaviortree_cpp/behavior_tree.h"
#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "nav_msgs/msg/path.hpp"
#include "rclcpp/node.hpp"

namespace BT {

// Numbers separated by semicolons, or JSON after `json:`. They throw std::runtime_error for a wrong
// count.

/// `x;y;z`
template <>
geometry_msgs::msg::Point convertFromString(StringView key);
/// `x;y;z;w`
template <>
geometry_msgs::msg::Quaternion convertFromString(StringView key);
/// `stamp in ns;frame;x;y;z;qx;qy;qz;qw`
template <>
geometry_msgs::msg::PoseStamped convertFromString(StringView key);
/// As many poses as there are.
template <>
std::vector<geometry_msgs::msg::PoseStamped> convertFromString(StringView key);
/// `stamp in ns;frame`, and poses.
template <>
nav_msgs::msg::Path convertFromString(StringView key);
template <>
std::chrono::milliseconds convertFromString(StringView key);
template <>
std::set<int> convertFromString(StringView key);

/// The value of a port, else of the node's parameter of that name.
template <typename T1, typename T2 = BT::TreeNode>
T1 deconflictPortAndParamFrame(rclcpp::Node::SharedPtr node, std::string param_name,
                               const T2* behavior_tree_node) {
  T1 value{};
  bool is_given = static_cast<bool>(behavior_tree_node->getInput(param_name, value));
  if constexpr (std::is_same_v<T1, std::string>) is_given = is_given && !value.empty();
  if (!is_given) node->get_parameter(param_name, value);
  return value;
}

/// The value of a port, else of the blackboard's entry of that name. False when there is neither.
template <typename T>
bool getInputPortOrBlackboard(const BT::TreeNode& bt_node, const BT::Blackboard& blackboard,
                              const std::string& param_name, T& value) {
  return bt_node.getInput<T>(param_name, value) || blackboard.get<T>(param_name, value);
}

#define getInputOrBlackboard(name, value) \
  getInputPortOrBlackboard(*this, *(this->config().blackboard), name, value);

}  // namespace BT
