// See host.hpp.
#include "ros/host.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace ros2wasm_sim {
namespace {

rclcpp::Parameter parameter_of(const std::string& name, const std::string& type,
                               const std::string& text) {
  if (type == "int") return {name, std::stoi(text)};
  if (type == "double" || type == "float") return {name, std::stod(text)};
  if (type == "bool") return {name, text == "true" || text == "1"};
  return {name, text};
}

/// Old files write `~/out:=scan` as an argument, without a flag, or several words in one:
/// `--ros-args --remap ~/out:=scan`.
void add_arguments(const std::string& text, std::vector<std::string>& arguments) {
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word == "--ros-args") continue;
    const std::string& before = arguments.back();
    const bool has_flag = before != "--ros-args" && before.front() == '-';
    if (word.find(":=") != std::string::npos && !has_flag) arguments.emplace_back("-r");
    arguments.push_back(word);
  }
}

}  // namespace

Host::Host(rclcpp::Node::SharedPtr node, rclcpp::Executor::SharedPtr executor, std::uint64_t seed)
    : node_(std::move(node)), executor_(std::move(executor)), seed_(seed) {}

rclcpp::Node::SharedPtr Host::add_plugin_node(const Plugin& plugin) {
  const Parameters ros = Parameters(plugin.xml).inside("ros");
  std::vector<std::string> arguments{"--ros-args"};
  for (const std::string& one : ros.all("remapping")) add_arguments(one, arguments);
  for (const std::string& one : ros.all("argument")) add_arguments(one, arguments);
  rclcpp::NodeOptions options;
  options.arguments(arguments);
  std::vector<rclcpp::Parameter> overrides;
  for (const Parameters& one : ros.each("parameter")) {
    const auto* name = one.xml().element->attribute("name");
    const auto* type = one.xml().element->attribute("type");
    if (name == nullptr) continue;
    try {
      overrides.push_back(
          parameter_of(*name, type == nullptr ? "string" : *type, one.xml().element->text));
    } catch (const std::logic_error&) {
      RCLCPP_ERROR(node_->get_logger(),
                   "Plugin [%s]: the value of parameter [%s] is not of its type",
                   plugin.name.c_str(), name->c_str());
    }
  }
  options.parameter_overrides(overrides);
  const std::string where =
      plugin.robot_namespace.empty() ? ros.text("namespace", "") : plugin.robot_namespace;
  auto node = std::make_shared<rclcpp::Node>(plugin.name, where, options);
  const std::string name = node->get_fully_qualified_name();
  if (std::find(names_.begin(), names_.end(), name) != names_.end())
    throw std::runtime_error(
        "Found multiple nodes with same name: " + name +
        ". This might be due to multiple plugins using the same name. Try changing one of "
        "the plugin names or use a different ROS namespace.");
  names_.push_back(name);
  executor_->add_node(node);
  return node;
}

void Host::remove_node(const rclcpp::Node::SharedPtr& node) {
  executor_->remove_node(node);
  names_.erase(std::remove(names_.begin(), names_.end(), node->get_fully_qualified_name()),
               names_.end());
}

}  // namespace ros2wasm_sim
