// See parameters.hpp.
#include "ros2wasm_parameters/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "rclcpp/exceptions.hpp"

namespace ros2wasm_parameters {
namespace {

void describe_range(rcl_interfaces::msg::ParameterDescriptor& descriptor,
                    rclcpp::ParameterType type, double from, double to) {
  if (std::isinf(from) && std::isinf(to)) return;
  if (type == rclcpp::PARAMETER_DOUBLE) {
    rcl_interfaces::msg::FloatingPointRange range;
    range.from_value = std::max(from, std::numeric_limits<double>::lowest());
    range.to_value = std::min(to, std::numeric_limits<double>::max());
    descriptor.floating_point_range.push_back(range);
  }
  if (type == rclcpp::PARAMETER_INTEGER) {
    rcl_interfaces::msg::IntegerRange range;
    range.from_value =
        std::isinf(from) ? std::numeric_limits<int64_t>::lowest() : static_cast<int64_t>(from);
    range.to_value =
        std::isinf(to) ? std::numeric_limits<int64_t>::max() : static_cast<int64_t>(to);
    descriptor.integer_range.push_back(range);
  }
}

}  // namespace

Declarations::Declarations(rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node)
    : node_(std::move(node)) {}

rclcpp::Parameter Declarations::declared(const std::string& name,
                                         const rclcpp::ParameterValue& value, const About& about,
                                         double from, double to) {
  if (!node_->has_parameter(name)) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = about.description;
    descriptor.read_only = about.access == kReadOnly;
    describe_range(descriptor, value.get_type(), from, to);
    node_->declare_parameter(name, value, descriptor);
  }
  return node_->get_parameter(name);
}

void Declarations::start(const rclcpp::Parameter& now, Follower follower, Access access) {
  const std::string why = follower.check(now);
  if (!why.empty()) {
    throw rclcpp::exceptions::InvalidParameterValueException(
        "Invalid value set during initialization for parameter '" + now.get_name() + "': " + why);
  }
  follower.apply(now);
  if (access == kDynamic) followers_[now.get_name()] = std::move(follower);
}

std::string Declarations::check(const std::vector<rclcpp::Parameter>& parameters) const {
  for (const rclcpp::Parameter& parameter : parameters) {
    const auto found = followers_.find(parameter.get_name());
    if (found == followers_.end()) continue;
    try {
      std::string why = found->second.check(parameter);
      if (!why.empty()) return why;
    } catch (const std::exception& error) {
      return error.what();  // a value of another type
    }
  }
  return "";
}

bool Declarations::apply(const std::vector<rclcpp::Parameter>& parameters) const {
  bool is_changed = false;
  for (const rclcpp::Parameter& parameter : parameters) {
    const auto found = followers_.find(parameter.get_name());
    if (found == followers_.end()) continue;
    found->second.apply(parameter);
    is_changed = true;
  }
  return is_changed;
}

}  // namespace ros2wasm_parameters
