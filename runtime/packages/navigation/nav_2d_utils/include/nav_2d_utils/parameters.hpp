// A parameter of a node, which is declared when nobody has done so.
#pragma once

#include <memory>
#include <string>

#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"

namespace nav_2d_utils {

template <class param_t>
param_t searchAndGetParam(const nav2_util::LifecycleNode::SharedPtr& nh,
                          const std::string& param_name, const param_t& default_value) {
  nav2_util::declare_parameter_if_not_declared(nh, param_name,
                                               rclcpp::ParameterValue(default_value));
  return nh->get_parameter(param_name).get_value<param_t>();
}

}  // namespace nav_2d_utils
