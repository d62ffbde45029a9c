// See tree_settings.hpp.
#include "nav2_behavior_tree/detail/tree_settings.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "nav2_util/node_utils.hpp"

namespace nav2_behavior_tree {
namespace detail {
namespace {

using std::chrono::milliseconds;

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += " " + name;
  return result;
}

void declare_error_codes(rclcpp_lifecycle::LifecycleNode& node) {
  if (node.has_parameter("error_code_names")) return;
  const auto value =
      node.declare_parameter("error_code_names", rclcpp::ParameterType::PARAMETER_STRING_ARRAY);
  if (value.get_type() != rclcpp::ParameterType::PARAMETER_NOT_SET) {
    RCLCPP_INFO(node.get_logger(), "Error_code parameters were set to:%s",
                joined(value.get<std::vector<std::string>>()).c_str());
    return;
  }
  const std::vector<std::string> names = {"follow_path_error_code", "compute_path_error_code"};
  RCLCPP_WARN(node.get_logger(),
              "Error_code parameters were not set. Using default values of:%s\nMake sure these "
              "match your BT and there are not other sources of error codes you reported to your "
              "application",
              joined(names).c_str());
  node.set_parameter({"error_code_names", names});
}

milliseconds duration(const rclcpp_lifecycle::LifecycleNode& node, const char* name) {
  return milliseconds(node.get_parameter(name).as_int());
}

}  // namespace

void declare_tree_parameters(rclcpp_lifecycle::LifecycleNode& node) {
  const auto declare = [&node](const char* name, auto value) {
    nav2_util::declare_parameter_if_not_declared(&node, name, rclcpp::ParameterValue(value));
  };
  declare("bt_loop_duration", 10);
  declare("default_server_timeout", 20);
  declare("default_cancel_timeout", 20);
  declare("action_server_result_timeout", 900.0);
  declare("always_reload_bt_xml", false);
  declare("wait_for_service_timeout", 1000);
  declare_error_codes(node);
}

TreeSettings read_tree_settings(const rclcpp_lifecycle::LifecycleNode& node) {
  TreeSettings result;
  result.loop_duration = duration(node, "bt_loop_duration");
  if (result.loop_duration <= milliseconds(0)) {
    throw std::invalid_argument("bt_loop_duration is not a positive number of milliseconds");
  }
  result.server_timeout = duration(node, "default_server_timeout");
  result.cancel_timeout = duration(node, "default_cancel_timeout");
  result.wait_for_service_timeout = duration(node, "wait_for_service_timeout");
  result.always_reload = node.get_parameter("always_reload_bt_xml").as_bool();
  const double seconds = node.get_parameter("action_server_result_timeout").as_double();
  result.result_timeout =
      rclcpp::Duration::from_seconds(seconds).to_chrono<decltype(result.result_timeout)>();
  return result;
}

void write_tree_settings(BT::Blackboard& blackboard, const rclcpp::Node::SharedPtr& node,
                         const TreeSettings& settings) {
  blackboard.set("node", node);
  blackboard.set("server_timeout", settings.server_timeout);
  blackboard.set("cancel_timeout", settings.cancel_timeout);
  blackboard.set("bt_loop_duration", settings.loop_duration);
  blackboard.set("wait_for_service_timeout", settings.wait_for_service_timeout);
}

rclcpp::Node::SharedPtr make_client_node(const rclcpp_lifecycle::LifecycleNode::SharedPtr& node,
                                         const std::string& action_name) {
  std::string name = action_name;
  std::replace(name.begin(), name.end(), '/', '_');
  const bool uses_sim_time = node->get_parameter("use_sim_time").as_bool();
  const auto options = rclcpp::NodeOptions().arguments(
      {"--ros-args", "-r", std::string("__node:=") + node->get_name() + "_" + name + "_rclcpp_node",
       "-p", std::string("use_sim_time:=") + (uses_sim_time ? "true" : "false"), "--"});
  auto result = std::make_shared<rclcpp::Node>("_", options);
  const auto declare = [&node](const char* parameter, auto value) {
    nav2_util::declare_parameter_if_not_declared(node, parameter, rclcpp::ParameterValue(value));
  };
  declare("global_frame", std::string("map"));
  declare("robot_base_frame", std::string("base_link"));
  declare("transform_tolerance", 0.1);
  rclcpp::copy_all_parameter_values(node, result);
  return result;
}

std::optional<uint16_t> least_error_code(const BT::Blackboard& blackboard,
                                         const std::vector<std::string>& names) {
  std::optional<uint16_t> least;
  for (const std::string& name : names) {
    int code = 0;
    try {
      if (!blackboard.get(name, code) || code == 0) continue;
    } catch (const std::exception&) {
      continue;  // not a number
    }
    if (!least || code < *least) least = static_cast<uint16_t>(code);
  }
  return least;
}

}  // namespace detail
}  // namespace nav2_behavior_tree
