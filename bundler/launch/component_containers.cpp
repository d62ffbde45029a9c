// See component_containers.hpp. The words are those of rclcpp_components/component_program.hpp.
#include "bundler/launch/component_containers.hpp"

#include <algorithm>
#include <iterator>
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
constexpr const char* kCode = "R2W0417";

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

Outcome<ContainerProcesses> container_processes(const LaunchProcess& container,
                                                const ParameterFiles& parameter_files) {
  const NodeEntry& node = container.node;
  ContainerProcesses result;
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
    warn("`" + name + "` is left out of the site", "no component is loaded into it");
  const bool is_known = std::find(std::begin(kContainers), std::end(kContainers),
                                  node.executable.value) != std::end(kContainers);
  if (!is_known)
    warn("`" + node.executable.value + "` runs as `component_container`",
         "rclcpp_components has no container of this name");
  std::vector<std::vector<std::string>> words;  // of each process
  for (const LaunchComponent& component : container.components) {
    const std::string& package = component.node.package.value;
    auto process = std::find_if(result.processes.begin(), result.processes.end(),
                                [&](const auto& one) { return one.node.package.value == package; });
    if (process == result.processes.end()) {
      LaunchProcess own = container;
      own.components.clear();
      own.node.package = component.node.package;
      if (!is_known) own.node.executable.value = kContainers[0];
      if (!result.processes.empty() && own.node.name) own.node.name->value += "_" + package;
      process = result.processes.insert(result.processes.end(), std::move(own));
      words.emplace_back();
    }
    const auto files = file_rules(component.node, parameter_files);
    if (!files) return files.errors();
    add_words(component, *files,
              words[static_cast<std::size_t>(process - result.processes.begin())]);
  }
  // Before the container's own, which may end with `--ros-args`.
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::vector<std::string>& all = result.processes[i].node.arguments;
    all.insert(all.begin(), words[i].begin(), words[i].end());
  }
  return result;
}

}  // namespace ros2wasm
