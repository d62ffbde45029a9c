// See launch_file_nodes.hpp.
#include "bundler/launch/launch_file_nodes.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "bundler/launch/component_containers.hpp"
#include "bundler/launch/launch_evaluation.hpp"
#include "workspace_schema/diagnostic_list.hpp"

namespace ros2wasm {
namespace {

/// Packages of programs that are no part of any site, and what stands in for them. A package that
/// is installed is started, whatever its name.
struct StandIn {
  std::string_view package;  ///< ends with `*`: all that begin so
  std::string_view instead;
};

constexpr StandIn kStandIns[] = {
    {"gazebo*", "a site has no simulator"},
    {"ros_gz*", "a site has no simulator"},
    {"ros_ign*", "a site has no simulator"},
    {"joint_state_publisher_gui", "joint_state_publisher publishes the joints' zero positions"},
    {"plotjuggler*", "the page shows the messages of topics"},
    {"rqt*", "the page shows nodes and topics"},
    {"rviz*", "the page shows the messages of topics"},
    {"xterm", "a site has no windows of programs"},
};

const StandIn* stand_in(const std::string& package) {
  for (const StandIn& one : kStandIns) {
    const bool begins = one.package.ends_with('*');
    if (begins ? package.starts_with(one.package.substr(0, one.package.size() - 1))
               : package == one.package)
      return &one;
  }
  return nullptr;
}

Diagnostic left_out_warning(const std::string& what, const std::string& why,
                            const SourceSpan& span) {
  return {.code = "R2W0415",
          .severity = Severity::kWarning,
          .message = "`" + what + "` is left out of the site",
          .span = span,
          .why = {why}};
}

struct Start {
  std::optional<LaunchTrigger> on;  ///< of a node that runs: its place among these
  double after_s = 0;
};

/// A process that no site runs is over as soon as it would have begun. `kept`: numbers of the
/// others, ascending.
Start start_of(const LaunchProcess& process, const std::vector<LaunchProcess>& all,
               const std::vector<std::size_t>& kept) {
  Start start{.on = process.start_on, .after_s = process.start_after_s};
  while (start.on) {
    const auto at = std::lower_bound(kept.begin(), kept.end(), start.on->process);
    if (at != kept.end() && *at == start.on->process) {
      start.on->process = static_cast<std::size_t>(at - kept.begin());
      break;
    }
    const LaunchProcess& missing = all[start.on->process];  // it stands before this one
    start.after_s += missing.start_after_s;
    start.on = missing.start_on;
  }
  return start;
}

}  // namespace

Outcome<LaunchFileNodes> launch_file_nodes(const std::string& path,
                                           const std::map<std::string, std::string>& given,
                                           const LaunchWorld& world,
                                           const std::vector<InstalledPackage>& installed,
                                           const SourceSpan& from, const LeftOutChains& left_out) {
  auto description = evaluate_launch(path, given, world, from);
  if (!description) return std::move(description).errors();
  LaunchFileNodes result;
  result.warnings = std::move(description->warnings);
  for (const LaunchLeftOut& one : description->left_out)
    result.warnings.push_back(left_out_warning(one.what, one.instead, one.span));

  std::vector<LaunchProcess> processes;
  std::vector<std::size_t> numbers;  // in the description
  std::vector<NodeEntry> entries;
  Diagnostics errors;
  for (LaunchProcess& process : description->processes) {
    const std::string& package = process.node.package.value;
    const bool is_known = left_out.contains(package) ||
                          std::any_of(installed.begin(), installed.end(),
                                      [&](const auto& one) { return one.name == package; });
    const StandIn* instead = is_known ? nullptr : stand_in(package);
    if (instead != nullptr) {
      result.warnings.push_back(left_out_warning(package + "/" + process.node.executable.value,
                                                 std::string(instead->instead), process.node.span));
      continue;
    }
    const auto number = static_cast<std::size_t>(&process - description->processes.data());
    const auto keep = [&](const LaunchProcess& one) {
      numbers.push_back(number);
      entries.push_back(one.node);
      processes.push_back(one);
    };
    if (!is_container(process)) {
      keep(process);
    } else if (const auto made = container_processes(process, description->parameter_files)) {
      append(result.warnings, made->warnings);
      for (const LaunchProcess& one : made->processes) keep(one);
    } else {
      append(errors, made.errors());
    }
  }
  auto nodes = launch_nodes(entries, installed, description->parameter_files, left_out);
  if (!nodes) errors.insert(errors.end(), nodes.errors().begin(), nodes.errors().end());
  if (!errors.empty()) return errors;

  // launch_nodes() keeps the order and leaves none out.
  for (std::size_t i = 0; i < processes.size(); ++i) {
    LaunchNode& node = (*nodes)[i];
    node.environment = std::move(processes[i].environment);
    const Start start = start_of(processes[i], description->processes, numbers);
    if (start.on) {
      node.start_on_node = (*nodes)[start.on->process].id;
      node.start_on_exit = start.on->event == LaunchEvent::kExit;
    }
    node.start_after_s = start.after_s;
    node.respawn_delay_s = processes[i].respawn_delay_s;
    node.shutdown_on_exit = processes[i].shutdown_on_exit;
  }
  result.nodes = std::move(*nodes);
  result.files = std::move(description->files);
  for (const LaunchLine& line : description->lines)
    result.remarks.push_back("the launch file says: " + line.text);
  return result;
}

}  // namespace ros2wasm
