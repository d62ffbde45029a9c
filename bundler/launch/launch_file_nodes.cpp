// See launch_file_nodes.hpp.
#include "bundler/launch/launch_file_nodes.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "bundler/launch/component_containers.hpp"
#include "bundler/launch/launch_evaluation.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace {

/// Moments of the launch file as those of the nodes that run.
class Moments {
 public:
  /// `kept`: numbers of the processes that run, ascending; `nodes` are what they became.
  Moments(const std::vector<LaunchProcess>& all, const std::vector<std::size_t>& kept,
          const std::vector<LaunchNode>& nodes)
      : all_(all), kept_(kept), nodes_(nodes) {}

  /// The node that a process became.
  [[nodiscard]] const LaunchNode* node(std::size_t process) const {
    const auto at = std::lower_bound(kept_.begin(), kept_.end(), process);
    if (at == kept_.end() || *at != process) return nullptr;
    return &nodes_[static_cast<std::size_t>(at - kept_.begin())];
  }

  /// Whether it waits for what a process prints that no site runs.
  [[nodiscard]] bool never(std::optional<LaunchTrigger> on) const {
    while (on && on->event != LaunchEvent::kShutdown && node(on->process) == nullptr) {
      if (on->event == LaunchEvent::kOutput) return true;
      on = all_[on->process].start_on;
    }
    return false;
  }

  /// A process that no site runs is over as soon as it would have begun: `after_s` grows by that.
  LaunchMoment of(std::optional<LaunchTrigger> on, double& after_s) const {
    while (on && on->event != LaunchEvent::kShutdown) {
      if (const LaunchNode* other = node(on->process)) {
        return {.node = other->id,
                .event = on->event,
                .name = on->event == LaunchEvent::kTransition ? other->label : "",
                .change = on->change,
                .output = on->output,
                .once = on->once,
                .handler = on->handler};
      }
      const LaunchProcess& missing = all_[on->process];  // it stands before this one
      after_s += missing.start_after_s;
      on = missing.start_on;
    }
    LaunchMoment result;
    if (on) result.event = LaunchEvent::kShutdown;
    return result;
  }

 private:
  const std::vector<LaunchProcess>& all_;
  const std::vector<std::size_t>& kept_;
  const std::vector<LaunchNode>& nodes_;
};

/// In the order in which they are done at the same moment: what is said comes first.
std::vector<LaunchStep> steps_of(const LaunchDescription& description, const Moments& moments) {
  std::vector<LaunchStep> steps;
  const auto add = [&](LaunchStep step, const auto& of) {
    if (moments.never(of.on)) return;
    step.after_s = of.after_s;
    step.on = moments.of(of.on, step.after_s);
    step.span = of.span;
    steps.push_back(std::move(step));
  };
  for (const LaunchLine& one : description.lines) {
    LaunchStep step;
    step.text = one.text;
    step.level = one.level;
    add(std::move(step), one);
  }
  for (const LaunchTransitions& one : description.transitions) {
    const LaunchNode* node = moments.node(*one.process);
    if (node == nullptr) continue;  // it is skipped, and said so
    LaunchStep step;
    step.kind = LaunchStepKind::kTransition;
    step.node = node->id;
    step.name = one.node;
    step.transitions = one.transitions;
    add(std::move(step), one);
  }
  for (const LaunchEnd& one : description.ends) {
    const LaunchNode* node = moments.node(one.process);
    if (node == nullptr) continue;
    LaunchStep step;
    step.kind = LaunchStepKind::kEnd;
    step.node = node->id;
    add(std::move(step), one);
  }
  for (const LaunchShutdown& one : description.shutdowns) {
    LaunchStep step;
    step.kind = LaunchStepKind::kShutdown;
    step.text = one.reason;
    add(std::move(step), one);
  }
  return steps;
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
  const auto is_known = [&](const std::string& package) {
    return left_out.contains(package) ||
           std::any_of(installed.begin(), installed.end(),
                       [&](const auto& one) { return one.name == package; });
  };
  append(result.warnings, left_out_of_site(*description, is_known, world));
  result.panels = stand_in_panels(*description, is_known);

  std::vector<LaunchProcess> processes;
  std::vector<std::size_t> numbers;  // in the description
  std::vector<NodeEntry> entries;
  Diagnostics errors;
  for (LaunchProcess& process : description->processes) {
    if (has_stand_in(process.node.package.value, is_known)) continue;
    const auto number = static_cast<std::size_t>(&process - description->processes.data());
    const auto keep = [&](const LaunchProcess& one) {
      numbers.push_back(number);
      entries.push_back(one.node);
      processes.push_back(one);
    };
    if (!is_container(process)) {
      keep(process);
    } else if (const auto made = container_process(process, description->parameter_files)) {
      append(result.warnings, made->warnings);
      if (made->process) keep(*made->process);
    } else {
      append(errors, made.errors());
    }
  }
  auto nodes = launch_nodes(entries, installed, description->parameter_files, left_out);
  if (!nodes) errors.insert(errors.end(), nodes.errors().begin(), nodes.errors().end());
  if (!errors.empty()) return errors;

  // launch_nodes() keeps the order and leaves none out.
  const Moments moments(description->processes, numbers, *nodes);
  for (std::size_t i = 0; i < processes.size(); ++i) {
    LaunchNode& node = (*nodes)[i];
    node.environment = std::move(processes[i].environment);
    node.start_after_s = processes[i].start_after_s;
    node.start_on = moments.of(processes[i].start_on, node.start_after_s);
    node.respawn_max_retries = processes[i].respawn_max_retries;
    node.respawn_delay_s = processes[i].respawn_delay_s;
    node.shutdown_on_exit = processes[i].shutdown_on_exit;
  }
  result.steps = steps_of(*description, moments);
  result.nodes = std::move(*nodes);
  result.files = std::move(description->files);
  result.arguments = std::move(description->arguments);
  for (const LaunchLine& line : description->lines)
    result.remarks.push_back("the launch file says: " + line.text);
  return result;
}

}  // namespace ros2wasm
