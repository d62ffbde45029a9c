// See node_utils.hpp.
#include "nav2_util/node_utils.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>

namespace nav2_util {

std::string sanitize_node_name(const std::string& potential_node_name) {
  std::string name = potential_node_name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char letter) { return std::isalnum(letter) == 0; },
      '_');
  return name;
}

std::string add_namespaces(const std::string& top_ns, const std::string& sub_ns) {
  if (top_ns.empty() || top_ns.back() != '/') return top_ns + "/" + sub_ns;
  return (top_ns.front() == '/' ? "" : "/") + top_ns + sub_ns;
}

std::string time_to_string(size_t len) {
  const auto now = std::chrono::high_resolution_clock::now().time_since_epoch();
  const std::string digits = std::to_string(now.count());
  if (digits.size() >= len) return digits.substr(digits.size() - len);
  return std::string(len - digits.size(), '0') + digits;
}

std::string generate_internal_node_name(const std::string& prefix) {
  constexpr size_t kDigits = 8;
  return sanitize_node_name(prefix) + "_" + time_to_string(kDigits);
}

rclcpp::Node::SharedPtr generate_internal_node(const std::string& prefix) {
  const std::string rule = "__node:=" + generate_internal_node_name(prefix);
  return rclcpp::Node::make_shared("_", rclcpp::NodeOptions()
                                            .start_parameter_services(false)
                                            .start_parameter_event_publisher(false)
                                            .arguments({"--ros-args", "-r", rule, "--"}));
}

void setSoftRealTimePriority() {
  RCLCPP_WARN(rclcpp::get_logger("nav2_util"),
              "Cannot set as real-time thread: threads of a browser have no priorities");
}

}  // namespace nav2_util
