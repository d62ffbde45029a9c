// See launch_evaluator.hpp: the actions that start processes, and what belongs to a process.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <utility>

#include "bundler/launch/launch_evaluator.hpp"
#include "bundler/launch/launch_values.hpp"
#include "bundler/launch/node_arguments.hpp"
#include "bundler/launch/ros2_command.hpp"
#include "bundler/launch/simulator_command.hpp"
#include "workspace_schema/base/names.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

/// Puts words together as a shell splits them.
class Words {
 public:
  /// Text of the file: spaces divide, quotes hold together.
  void plain(const std::string& text) {
    for (const char c : text) {
      if (quote_ != '\0') {
        if (c == quote_) {
          quote_ = '\0';
        } else {
          word_ += c;
        }
      } else if (c == '\'' || c == '"') {
        quote_ = c;
        begun_ = true;
      } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
        end();
      } else {
        word_ += c;
        begun_ = true;
      }
    }
  }
  /// The result of a substitution is never split into words.
  void whole(const std::string& text) {
    word_ += text;
    begun_ = true;
  }
  [[nodiscard]] bool open() const { return quote_ != '\0'; }
  std::vector<std::string> finish() {
    end();
    return std::move(words_);
  }

 private:
  void end() {
    if (begun_) words_.push_back(std::exchange(word_, {}));
    begun_ = false;
  }

  std::vector<std::string> words_;
  std::string word_;
  char quote_ = '\0';
  bool begun_ = false;
};

/// A command line that starts a node.
struct NodeProgram {
  std::string package;
  std::string executable;
  std::vector<std::string> arguments;
};

std::optional<NodeProgram> node_program(const std::vector<std::string>& words,
                                        const LaunchWorld& world) {
  if (words.size() >= 4 && names_program(words[0], "ros2") && words[1] == "run")
    return NodeProgram{words[2], words[3], {words.begin() + 4, words.end()}};
  const std::filesystem::path path(words[0]);
  const std::string package = path.parent_path().filename().string();
  const auto prefix = world.prefix_of(package);
  if (!prefix || path != std::filesystem::path(*prefix) / "lib" / package / path.filename())
    return std::nullopt;
  return NodeProgram{package, path.filename().string(), {words.begin() + 1, words.end()}};
}

std::optional<NodeOutput> output_of(const std::string& text) {
  if (text == "screen") return NodeOutput::kScreen;
  if (text == "log" || text == "own_log") return NodeOutput::kLog;
  if (text == "both" || text == "full") return NodeOutput::kBoth;
  return std::nullopt;
}

/// Before the packages are there, nobody knows whether one of them brings ros2_control.
std::string simulator_of(const LaunchWorld& world) {
  const std::string controlled(kControlledSimulatorPackage);
  const bool is_known = !world.is_later && world.prefix_of(controlled);
  return is_known ? controlled : std::string(kSimulatorPackage);
}

}  // namespace

std::optional<std::vector<std::string>> LaunchEvaluator::command_line(const LaunchEntity& entity,
                                                                      std::string_view name) {
  const LaunchAttribute* attribute = entity.attribute(name);
  if (attribute == nullptr) return std::vector<std::string>();
  if (const auto* list = std::get_if<std::vector<LaunchScalar>>(&attribute->value)) {
    // Words as they are; of launch files in Python.
    std::vector<std::string> words;
    for (const LaunchScalar& one : *list) {
      const auto* word = std::get_if<std::string>(&one);
      auto plain = word == nullptr ? std::nullopt : evaluated(*word, attribute->span);
      if (!plain) return std::nullopt;
      words.push_back(std::move(*plain));
    }
    return words;
  }
  const auto* written = std::get_if<std::string>(&attribute->value);
  if (written == nullptr) {
    const auto plain = text(entity, name);
    return plain ? std::optional(std::vector<std::string>{*plain}) : std::nullopt;
  }
  const auto parsed = parse_launch_text(*written, attribute->span);
  if (!parsed) {
    errors_.insert(errors_.end(), parsed.errors().begin(), parsed.errors().end());
    return std::nullopt;
  }
  Words words;
  for (const LaunchPiece& piece : *parsed) {
    if (const auto* plain = std::get_if<std::string>(&piece)) {
      words.plain(*plain);
      continue;
    }
    auto part = evaluate_text({piece}, attribute->span, scope_, place_, world_);
    if (!part) {
      errors_.insert(errors_.end(), part.errors().begin(), part.errors().end());
      return std::nullopt;
    }
    words.whole(*part);
  }
  if (words.open()) {
    fail("R2W0410", "a quote in `" + std::string(name) + "` is not closed", attribute->span);
    return std::nullopt;
  }
  return words.finish();
}

std::optional<ParameterValue> LaunchEvaluator::value(const LaunchAttribute& attribute,
                                                     const std::string& type,
                                                     const std::string& separator) {
  const auto typed = [&](const std::string& written) -> std::optional<ParameterValue> {
    const auto plain = evaluated(written, attribute.span);
    if (!plain) return std::nullopt;
    // YAML has types, and a text without substitutions keeps that of its own.
    if (language_ == LaunchLanguage::kYaml && type.empty() && separator.empty() &&
        written.find("$(") == std::string::npos)
      return ParameterValue(*plain);
    auto result = typed_parameter(*plain, type, separator, attribute.span);
    if (result) return std::move(*result);
    errors_.insert(errors_.end(), result.errors().begin(), result.errors().end());
    return std::nullopt;
  };
  if (const auto* written = std::get_if<std::string>(&attribute.value)) return typed(*written);
  if (const auto* list = std::get_if<std::vector<LaunchScalar>>(&attribute.value)) {
    std::vector<ParameterValue> items;
    for (const LaunchScalar& one : *list) {
      if (const auto* written = std::get_if<std::string>(&one)) {
        auto item = typed(*written);
        if (!item) return std::nullopt;
        items.push_back(std::move(*item));
      } else {
        std::visit([&](const auto& held) { items.emplace_back(held); }, one);
      }
    }
    if (auto result = list_parameter(items)) return result;
    fail("R2W0410", "the items of a parameter's list must have one type", attribute.span);
    return std::nullopt;
  }
  if (!type.empty()) return typed(*launch_value_text(attribute.value));
  if (const bool* one = std::get_if<bool>(&attribute.value)) return *one;
  if (const auto* one = std::get_if<std::int64_t>(&attribute.value)) return *one;
  return std::get<double>(attribute.value);
}

std::optional<std::string> LaunchEvaluator::parameter_file(const LaunchEntity& entity,
                                                           const LaunchAttribute& from,
                                                           bool substituted) {
  const auto named = text(entity, from.name);
  if (!named) return std::nullopt;
  const std::string path = named->starts_with('/') ? *named : place_.directory() + "/" + *named;
  auto content = world_.read(path);
  if (!content && comes_later(path, from.span)) return std::nullopt;
  if (!content) {
    fail("R2W0403", "the parameter file `" + path + "` cannot be read", from.span,
         content.errors().front().why);
    return std::nullopt;
  }
  files_.insert(path);
  std::string key = path;
  if (substituted) {
    auto text = evaluated(*content, from.span);
    if (!text) return std::nullopt;
    content = std::move(*text);
    // The same file may come to something else in another place.
    for (int i = 2; description_.parameter_files.contains(key) &&
                    description_.parameter_files[key] != *content;
         ++i)
      key = path + "#" + std::to_string(i);
  }
  description_.parameter_files[key] = std::move(*content);
  return key;
}

void LaunchEvaluator::parameter(const LaunchEntity& entity, const std::string& prefix,
                                NodeEntry& node) {
  const LaunchAttribute* from = entity.attribute("from");
  if (from != nullptr) {
    if (auto key = parameter_file(entity, *from, flag(entity, "allow_substs", false)))
      node.parameter_files.push_back({std::move(*key), from->span});
    return;
  }
  const auto name = needed_text(entity, "name");
  if (!name) return;
  const LaunchAttribute* set = entity.attribute("value");
  const bool nested = !entity.children.empty();
  if ((set != nullptr) == nested) {
    fail("R2W0410", "`param` has either a value or params of its own", entity.span);
    return;
  }
  if (nested) {
    for (const LaunchEntity& part : entity.children) {
      if (part.tag == "param") {
        parameter(part, prefix + *name + ".", node);
      } else {
        fail("R2W0410", "`" + part.tag + "` cannot stand in `param`", part.span);
      }
    }
    return;
  }
  const std::string type = text(entity, "type").value_or("");
  const std::string separator = text(entity, "value_sep").value_or("");
  if (auto one = value(*set, type, separator))
    node.parameters.push_back({.name = prefix + *name,
                               .value = std::move(*one),
                               .files_before = node.parameter_files.size()});
}

void LaunchEvaluator::parameters_of(const LaunchEntity& entity, NodeEntry& node) {
  for (const LaunchParameter& one : scope_.parameters) {
    if (one.file) {
      node.parameter_files.push_back(*one.file);
    } else {
      node.parameters.push_back(
          {.name = one.name, .value = one.value, .files_before = node.parameter_files.size()});
    }
  }
  for (const LaunchEntity& part : entity.children)
    if (part.tag == "param") parameter(part, "", node);
}

std::optional<std::vector<std::pair<std::string, std::string>>> LaunchEvaluator::remappings_of(
    const LaunchEntity& entity) {
  std::vector<std::pair<std::string, std::string>> result = scope_.remappings;
  for (const LaunchEntity& part : entity.children) {
    if (part.tag != "remap") continue;
    auto from = needed_text(part, "from");
    auto to = needed_text(part, "to");
    if (!from || !to) return std::nullopt;
    result.emplace_back(std::move(*from), std::move(*to));
  }
  return result;
}

void LaunchEvaluator::process_options(const LaunchEntity& entity, LaunchProcess& process) {
  process.start_on = trigger_;
  process.start_after_s = after_s_;
  process.environment = scope_.environment;
  for (const LaunchEntity& part : entity.children) {
    if (part.tag != "env") continue;
    const auto name = needed_text(part, "name");
    auto set = needed_text(part, "value");
    if (name && set) process.environment[*name] = std::move(*set);
  }
  process.node.respawn = flag(entity, "respawn", false);
  process.respawn_delay_s = seconds(entity, "respawn_delay", 0);
  if (const auto written = text(entity, "respawn_max_retries")) {
    std::int64_t count = 0;
    const char* const end = written->data() + written->size();
    const auto [stop, error] = std::from_chars(written->data(), end, count);
    if (error != std::errc() || stop != end) {
      fail("R2W0410", "`respawn_max_retries` is a whole number, found `" + *written + "`",
           entity.attribute("respawn_max_retries")->span);
    } else if (count >= 0) {
      process.respawn_max_retries = count;
    }
  }
  if (const auto output = text(entity, "output")) {
    if (const auto kind = output_of(*output)) {
      process.node.output = *kind;
    } else {
      fail("R2W0410", "`output` is screen, log, both, own_log or full, found `" + *output + "`",
           entity.attribute("output")->span);
    }
  }
  if (const auto on_exit = text(entity, "on_exit")) {
    process.shutdown_on_exit = *on_exit == "shutdown";
    if (!process.shutdown_on_exit)
      fail("R2W0410", "`on_exit` is shutdown, found `" + *on_exit + "`",
           entity.attribute("on_exit")->span);
  }
}

std::optional<LaunchProcess> LaunchEvaluator::process_of(const LaunchEntity& entity) {
  const std::size_t errors_before = errors_.size();
  LaunchProcess process;
  NodeEntry& node = process.node;
  node.span = entity.span;
  const auto executable = text(entity, "exec");
  const auto package = needed_text(entity, "pkg");
  if (!executable || !package) return std::nullopt;
  node.executable = {*executable, entity.attribute("exec")->span};
  node.package = {*package, entity.attribute("pkg")->span};
  const char* named = entity.attribute("name") != nullptr ? "name" : "node_name";
  if (auto name = text(entity, named); name && !name->empty()) {
    if (const auto fault = node_name_fault(*name))
      fail("R2W0104", "`" + *name + "` cannot be a node's name: " + fault->why,
           entity.attribute(named)->span, {fault->rule});
    node.name = {std::move(*name), entity.attribute(named)->span};
  }
  if (auto whole = namespace_for(text(entity, "namespace").value_or(""))) {
    const LaunchAttribute* at = entity.attribute("namespace");
    const SourceSpan& span = at != nullptr ? at->span : entity.span;
    if (const auto fault = namespace_fault(*whole))
      fail("R2W0104", "`" + *whole + "` cannot be a namespace: " + fault->why, span, {fault->rule});
    node.name_space = {std::move(*whole), span};
  }
  if (auto words = command_line(entity, "args")) node.arguments = std::move(*words);
  if (auto words = command_line(entity, "ros_args")) node.ros_arguments = std::move(*words);
  if (auto remappings = remappings_of(entity)) node.remappings = std::move(*remappings);
  parameters_of(entity, node);
  process_options(entity, process);
  if (errors_.size() != errors_before) return std::nullopt;
  return process;
}

void LaunchEvaluator::lifecycle_node(const LaunchEntity& entity) {
  const bool starts_itself = flag(entity, "autostart", false);
  auto process = process_of(entity);
  if (!process) return;
  if (!process->node.name) {
    fail("R2W0410", "`lifecycle_node` needs the attribute `name`", entity.span);
    return;
  }
  const std::size_t number = description_.processes.size();
  add_process(entity, std::move(*process));
  if (!starts_itself || description_.processes.size() == number) return;
  description_.transitions.push_back(
      {.process = number,
       .node = {},
       .transitions = {1, 3},  // configure, activate
       .on = LaunchTrigger{.process = number, .event = LaunchEvent::kStart},
       .after_s = 0,
       .span = entity.span});
}

void LaunchEvaluator::node(const LaunchEntity& entity) {
  if (auto process = process_of(entity)) add_process(entity, std::move(*process));
}

void LaunchEvaluator::add_process(const LaunchEntity& entity, LaunchProcess process) {
  if (!starts_here(entity, program_label(process.node))) return;
  if (const std::int64_t own = number(entity, "process"); own >= 0)
    processes_[own] = description_.processes.size();
  description_.processes.push_back(std::move(process));
}

std::vector<LaunchComponent> LaunchEvaluator::components_of(const LaunchEntity& entity) {
  std::vector<LaunchComponent> result;
  for (const LaunchEntity& part : entity.children) {
    if (part.tag != "composable_node" || !applies(part)) continue;
    const auto package = needed_text(part, "pkg");
    const auto plugin = needed_text(part, "plugin");
    if (!package || !plugin) continue;
    LaunchComponent one{.node = {.span = part.span,
                                 .package = {*package, part.attribute("pkg")->span},
                                 .executable = {}},
                        .plugin = *plugin,
                        .extra_arguments = {}};
    if (auto name = text(part, "name")) one.node.name = {std::move(*name), part.span};
    if (auto whole = namespace_for(text(part, "namespace").value_or("")))
      one.node.name_space = {std::move(*whole), part.span};
    if (auto remappings = remappings_of(part)) one.node.remappings = std::move(*remappings);
    parameters_of(part, one.node);
    for (const LaunchEntity& extra : part.children) {
      if (extra.tag != "extra_arg") continue;
      auto name = needed_text(extra, "name");
      auto set = needed_text(extra, "value");
      if (name && set) one.extra_arguments.emplace_back(std::move(*name), std::move(*set));
    }
    result.push_back(std::move(one));
  }
  return result;
}

void LaunchEvaluator::container(const LaunchEntity& entity) {
  auto process = process_of(entity);
  auto components = components_of(entity);
  if (!process) return;
  process->components = std::move(components);
  add_process(entity, std::move(*process));
}

/// Into a container, which may stand behind it, by its node's name: a relative one is below `/`.
void LaunchEvaluator::load_components(const LaunchEntity& entity) {
  LoadedComponents loaded{.components = components_of(entity),
                          .process = number(entity, "process"),
                          .target = {},
                          .span = entity.span};
  if (loaded.process < 0) {
    auto target = needed_text(entity, "target");
    if (!target) return;
    loaded.target = (target->starts_with('/') ? "" : "/") + *target;
    loaded.span = entity.attribute("target")->span;
  }
  loaded_.push_back(std::move(loaded));
}

/// At the end: natively they wait for their container, which may be that of another launch.
void LaunchEvaluator::resolve_components() {
  auto& processes = description_.processes;
  for (LoadedComponents& loaded : loaded_) {
    const auto known = processes_.find(loaded.process);
    const auto container =
        loaded.process < 0
            ? std::find_if(processes.begin(), processes.end(),
                           [&](const LaunchProcess& one) {
                             return one.node.name && node_label(one.node) == loaded.target;
                           })
        : known == processes_.end()
            ? processes.end()
            : processes.begin() + static_cast<std::ptrdiff_t>(known->second);
    for (LaunchComponent& one : loaded.components) {
      if (container != processes.end()) {
        container->components.push_back(std::move(one));
        continue;
      }
      description_.left_out.push_back(
          {.what = one.plugin + " (package " + one.node.package.value + ")",
           .instead = "the launch file starts no container " +
                      (loaded.target.empty() ? "for it" : "`" + loaded.target + "`"),
           .span = loaded.span});
    }
  }
}

/// `ros2 run` and the path of an installed program start a node, those of Gazebo the site's own
/// simulator, other commands of `ros2` run as they are; all else is skipped.
void LaunchEvaluator::executable(const LaunchEntity& entity) {
  auto words = command_line(entity, "cmd");
  if (!words || words->empty()) return;
  std::string line;
  for (const std::string& word : *words) line += (line.empty() ? "" : " ") + word;
  const auto pass_over = [&](bool stays) {
    if (const std::int64_t own = number(entity, "process"); own >= 0)
      passed_over_[own] = {.on = trigger_, .after_s = after_s_, .stays = stays};
  };
  const auto leave_it_out = [&](std::string_view instead) {
    pass_over(false);
    description_.left_out.push_back(
        {.what = line, .instead = std::string(instead), .span = entity.span});
  };
  if (flag(entity, "shell", false)) {
    words = shell_words(without_which(line));
    if (!words || words->empty())
      return leave_it_out("a site has no shell, only the words of one command");
  }
  LaunchProcess process;
  process.node.span = entity.span;
  auto simulator = simulator_command(*words);
  if (simulator && !world_.prefix_of(std::string(kSimulatorPackage)))
    return leave_it_out("no channel of the workspace has the simulator, " +
                        std::string(kSimulatorPackage));
  if (simulator && simulator->program.empty()) return pass_over(true);
  if (simulator) {
    process.node.package = {simulator_of(world_), entity.span};
    process.node.executable = {std::move(simulator->program), entity.span};
    process.node.arguments = std::move(simulator->arguments);
  } else if (auto program = node_program(*words, world_)) {
    process.node.package = {std::move(program->package), entity.span};
    process.node.executable = {std::move(program->executable), entity.span};
    process.node.arguments = std::move(program->arguments);
  } else if (runs_in_site(*words)) {
    process.node.is_command = true;
    process.node.executable = {"ros2", entity.span};
    process.node.arguments.assign(words->begin() + 1, words->end());
  } else {
    return leave_it_out(instead_of_command(*words));
  }
  const std::size_t errors_before = errors_.size();
  process_options(entity, process);
  if (errors_.size() == errors_before) add_process(entity, std::move(process));
}

}  // namespace ros2wasm
