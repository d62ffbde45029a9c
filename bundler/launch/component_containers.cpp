// See component_containers.hpp. The words are those of rclcpp_components/component_program.hpp.
#include "bundler/launch/component_containers.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "bundler/launch/launch_values.hpp"
#include "bundler/launch/node_arguments.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kContainerPackage = "rclcpp_components";
/// Each package with components has all of them.
constexpr std::string_view kContainers[] = {"component_container", "component_container_mt",
                                            "component_container_isolated"};
constexpr DiagnosticCode kCode = "R2W0417";

void add_words(const LaunchComponent& component, const std::vector<FileRules>& files,
               std::vector<std::string>& words) {
  words.push_back("--component=" + component.plugin);
  for (const std::string& word : node_arguments(component.node, files))
    words.push_back("--component-arg=" + word);
  for (const auto& [name, value] : component.extra_arguments)
    if (launch_boolean(value).value_or(false)) words.push_back("--component-flag=" + name);
}

}  // namespace

bool is_container(const LaunchProcess& process) {
  return !process.components.empty() || process.node.package.value == kContainerPackage;
}

Outcome<ContainerProcess> container_process(const LaunchProcess& container,
                                            const ParameterFiles& parameter_files) {
  const NodeEntry& node = container.node;
  ContainerProcess result;
  const std::string name = node.package.value + "/" + node.executable.value;
  const auto warn = [&](std::string message, std::string why) {
    result.warnings.push_back({.code = kCode,
                               .severity = Severity::kWarning,
                               .message = std::move(message),
                               .span = node.span,
                               .why = {std::move(why)}});
  };
  if (node.package.value != kContainerPackage) {
    return Diagnostic{.code = kCode,
                      .message = "components cannot be loaded into `" + name + "`",
                      .span = node.span,
                      .why = {"a site loads them into the containers of rclcpp_components only"}};
  }
  if (container.components.empty())
    warn("`" + name + "` is skipped", "no component is loaded into it");
  const bool is_known = std::find(std::begin(kContainers), std::end(kContainers),
                                  node.executable.value) != std::end(kContainers);
  if (!is_known)
    warn("`" + node.executable.value + "` runs as `component_container`",
         "rclcpp_components has no container of this name");
  if (container.components.empty()) return result;
  LaunchProcess process = container;
  process.components.clear();
  process.node.package = container.components.front().node.package;
  if (!is_known) process.node.executable.value = kContainers[0];
  std::map<std::string, Spanned<std::string>> others;
  std::vector<std::string> words;
  for (const LaunchComponent& component : container.components) {
    const Spanned<std::string>& package = component.node.package;
    if (package.value != process.node.package.value) others.emplace(package.value, package);
    const auto files = file_rules(component.node, parameter_files);
    if (!files) return files.errors();
    add_words(component, *files, words);
  }
  for (auto& [name, package] : others) process.node.linked_with.push_back(std::move(package));
  // Before the container's own, which may end with `--ros-args`.
  process.node.arguments.insert(process.node.arguments.begin(), words.begin(), words.end());
  result.process = std::move(process);
  return result;
}

}  // namespace ros2wasm
