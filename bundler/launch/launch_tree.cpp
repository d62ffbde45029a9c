// See launch_tree.hpp. The keys of the JSON and their order are part of the format.
#include "bundler/launch/launch_tree.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "bundler/launch/launch_step.hpp"
#include "bundler/launch/lifecycle_transitions.hpp"
#include "bundler/launch/node_arguments.hpp"

namespace ros2wasm {
namespace {

std::string place(const SourceSpan& span) {
  return span.file + ":" + std::to_string(span.line);
}

std::string seconds(double time) {
  return parameter_text(time) + " s";
}

using Lines = std::vector<std::string>;

void add_arguments(const LaunchDescription& description, Lines& lines) {
  if (description.arguments.empty()) return;
  lines.emplace_back("arguments");
  for (const LaunchArgument& one : description.arguments) {
    std::string line = "  " + one.name + ":=" + one.value;
    if (one.given) line += one.default_value ? " (default: " + *one.default_value + ")" : "";
    if (!one.choices.empty()) {
      line += "  one of";
      for (const std::string& choice : one.choices) line += " " + choice;
    }
    if (!one.description.empty()) line += "  # " + one.description;
    lines.push_back(std::move(line));
  }
}

void add_parameters(const std::vector<ParameterEntry>& parameters, const std::string& indent,
                    Lines& lines) {
  for (const ParameterEntry& one : parameters)
    lines.push_back(indent + "param " + one.name + ": " + parameter_text(one.value));
}

std::string named(const LaunchProcess& process) {
  return program_label(process.node) + (process.node.name ? " " + node_label(process.node) : "");
}

std::string test_words(const LaunchLineTest& test) {
  struct Row {
    std::string_view how;
    std::string_view holds;
    std::string_view does_not;
  };
  constexpr Row kRows[] = {{"begins", "begins with", "does not begin with"},
                           {"contains", "contains", "does not contain"},
                           {"ends", "ends with", "does not end with"},
                           {"is", "is", "is not"}};
  const auto* row = std::find_if(std::begin(kRows), std::end(kRows),
                                 [&](const Row& one) { return one.how == test.how; });
  const std::string words(row == std::end(kRows) ? std::string_view(test.how)
                          : test.holds           ? row->holds
                                                 : row->does_not);
  return words + " `" + test.text + "`" + (test.any_case ? " in any case" : "");
}

std::string when_printed(const LaunchTrigger& trigger, const std::string& process) {
  std::string line = (trigger.once ? "the first time that " : "when ") + process + " prints";
  const char* joint = " what ";
  for (const LaunchLineTest& one : trigger.output.tests) {
    line += joint + test_words(one);
    joint = " and ";
  }
  return line + " (" + trigger.output.stream + ")";
}

std::string when(const LaunchTrigger& trigger, const std::vector<LaunchProcess>& processes) {
  switch (trigger.event) {
    case LaunchEvent::kStart:
      return "when " + named(processes[trigger.process]) + " has started";
    case LaunchEvent::kExit:
      return "when " + named(processes[trigger.process]) + " has ended";
    case LaunchEvent::kShutdown:
      return "when all ends";
    case LaunchEvent::kOutput:
      return when_printed(trigger, named(processes[trigger.process]));
    case LaunchEvent::kTransition:
      break;
  }
  const LaunchStateChange& change = trigger.change;
  return (trigger.once ? "the first time that " : "when ") + named(processes[trigger.process]) +
         (change.goal_state.empty() ? " leaves its state" : " becomes " + change.goal_state) +
         (change.start_state.empty() ? "" : ", was " + change.start_state) +
         (change.transition.empty() ? "" : ", by " + change.transition);
}

std::string label(std::int64_t transition) {
  for (const LifecycleTransitionRow& row : kTransitions)
    if (row.id == transition) return std::string(row.label);
  return std::to_string(transition);
}

void add_process(const LaunchProcess& process, const std::vector<LaunchProcess>& processes,
                 Lines& lines) {
  const NodeEntry& node = process.node;
  std::string head = program_label(node);
  if (node.name) {
    head += "  " + node_label(node);
  } else if (node.name_space) {
    head += " (" + node.name_space->value + ")";
  }
  lines.push_back(head + "  [" + place(node.span) + "]");
  if (process.start_on) lines.push_back("  " + when(*process.start_on, processes));
  if (process.start_after_s > 0) lines.push_back("  after " + seconds(process.start_after_s));
  if (node.respawn)
    lines.push_back("  respawn" +
                    (process.respawn_delay_s > 0 ? " after " + seconds(process.respawn_delay_s)
                                                 : std::string()) +
                    (process.respawn_max_retries
                         ? ", " + std::to_string(*process.respawn_max_retries) + " times at most"
                         : std::string()));
  if (process.shutdown_on_exit) lines.emplace_back("  when it ends, all ends");
  for (const auto& [name, value] : process.environment)
    lines.push_back("  env " + name + "=" + value);
  if (!node.is_command)
    for (const std::string& one : node.arguments) lines.push_back("  arg " + one);
  for (const auto& file : node.parameter_files) lines.push_back("  params from " + file.value);
  add_parameters(node.parameters, "  ", lines);
  for (const auto& [from, to] : node.remappings) lines.push_back("  remap " + from + " -> " + to);
  for (const LaunchComponent& one : process.components) {
    lines.push_back("  component " + one.node.package.value + " " + one.plugin +
                    (one.node.name ? "  " + node_label(one.node) : ""));
    for (const auto& file : one.node.parameter_files)
      lines.push_back("    params from " + file.value);
    add_parameters(one.node.parameters, "    ", lines);
    for (const auto& [from, to] : one.node.remappings)
      lines.push_back("    remap " + from + " -> " + to);
  }
}

void write_place(JsonWriter& json, const SourceSpan& span) {
  json.key("source").begin_object().field("file", span.file).field_integer("line", span.line);
  json.end_object();
}

void write_value(JsonWriter& json, const ParameterValue& value) {
  struct Writer {
    JsonWriter& json;
    void operator()(bool one) const { json.boolean(one); }
    void operator()(std::int64_t one) const { json.integer(one); }
    void operator()(double one) const { json.number(one); }
    void operator()(const std::string& one) const { json.string(one); }
  };
  const Writer writer{json};
  std::visit(
      [&](const auto& held) {
        if constexpr (requires { writer(held); }) {
          writer(held);
        } else {
          json.begin_array();
          for (const auto& one : held) writer(one);
          json.end_array();
        }
      },
      value);
}

std::string_view type_name(const ParameterValue& value) {
  constexpr std::array<std::string_view, 8> names{"bool",         "integer",     "double",
                                                  "string",       "bool_array",  "integer_array",
                                                  "double_array", "string_array"};
  return names[value.index()];
}

void write_parameters(JsonWriter& json, const std::vector<ParameterEntry>& parameters) {
  json.key("parameters").begin_array();
  for (const ParameterEntry& one : parameters) {
    json.begin_object().field("name", one.name).field("type", type_name(one.value)).key("value");
    write_value(json, one.value);
    json.end_object();
  }
  json.end_array();
}

void write_pairs(JsonWriter& json, const char* key,
                 const std::vector<std::pair<std::string, std::string>>& pairs) {
  json.key(key).begin_array();
  for (const auto& [from, to] : pairs) json.begin_array().string(from).string(to).end_array();
  json.end_array();
}

void write_texts(JsonWriter& json, const char* key, const std::vector<std::string>& texts) {
  json.key(key).begin_array();
  for (const std::string& one : texts) json.string(one);
  json.end_array();
}

void write_files(JsonWriter& json, const NodeEntry& node) {
  std::vector<std::string> files;
  for (const auto& file : node.parameter_files) files.push_back(file.value);
  write_texts(json, "parameter_files", files);
}

void write_component(JsonWriter& json, const LaunchComponent& one) {
  json.begin_object().field("package", one.node.package.value).field("plugin", one.plugin);
  if (one.node.name) json.field("name", one.node.name->value);
  if (one.node.name_space) json.field("namespace", one.node.name_space->value);
  write_files(json, one.node);
  write_parameters(json, one.node.parameters);
  write_pairs(json, "remappings", one.node.remappings);
  write_pairs(json, "extra_arguments", one.extra_arguments);
  json.end_object();
}

void write_trigger(JsonWriter& json, const char* key, const LaunchTrigger& trigger) {
  json.key(key).begin_object();
  if (trigger.event != LaunchEvent::kShutdown)
    json.field_integer("process", static_cast<std::int64_t>(trigger.process));
  json.field("event", launch_event_name(trigger.event));
  write_state_change(json, trigger.change);
  write_output(json, trigger.output);
  if (trigger.once) json.field_boolean("once", true);
  if (trigger.handler >= 0) json.field_integer("handler", trigger.handler);
  json.end_object();
}

/// Writes when a step is done, and its place in the source.
void write_moment(JsonWriter& json, const auto& step) {
  if (step.on) write_trigger(json, "on", *step.on);
  json.key("after").number(step.after_s);
  write_place(json, step.span);
}

void write_process(JsonWriter& json, const LaunchProcess& process) {
  const NodeEntry& node = process.node;
  json.begin_object()
      .field("package", node.package.value)
      .field("executable", node.executable.value);
  if (node.is_command) json.field_boolean("command", true);
  if (node.name) json.field("name", node.name->value);
  if (node.name_space) json.field("namespace", node.name_space->value);
  write_texts(json, "arguments", node.arguments);
  write_texts(json, "ros_arguments", node.ros_arguments);
  write_files(json, node);
  write_parameters(json, node.parameters);
  write_pairs(json, "remappings", node.remappings);
  json.key("environment").begin_object();
  for (const auto& [name, value] : process.environment) json.field(name, value);
  json.end_object();
  if (process.start_on) write_trigger(json, "start_on", *process.start_on);
  json.key("start_after").number(process.start_after_s);
  json.field_boolean("respawn", node.respawn);
  json.key("respawn_delay").number(process.respawn_delay_s);
  if (process.respawn_max_retries)
    json.field_integer("respawn_max_retries", *process.respawn_max_retries);
  json.field_boolean("shutdown_on_exit", process.shutdown_on_exit);
  json.key("components").begin_array();
  for (const LaunchComponent& one : process.components) write_component(json, one);
  json.end_array();
  write_place(json, node.span);
  json.end_object();
}

}  // namespace

void write_launch_argument(JsonWriter& json, const LaunchArgument& one) {
  json.begin_object().field("name", one.name).field("value", one.value);
  if (one.default_value) json.field("default", *one.default_value);
  json.field("description", one.description);
  write_texts(json, "choices", one.choices);
  write_place(json, one.span);
  json.end_object();
}

std::vector<std::string> launch_tree(const LaunchDescription& description) {
  Lines lines;
  add_arguments(description, lines);
  for (const LaunchProcess& process : description.processes)
    add_process(process, description.processes, lines);
  const auto at = [&](const auto& step) {
    return (step.on ? "  " + when(*step.on, description.processes) : "") +
           (step.after_s > 0 ? "  after " + seconds(step.after_s) : "") + "  [" + place(step.span) +
           "]";
  };
  for (const LaunchLine& line : description.lines)
    lines.push_back("log " + line.level + ": " + line.text + at(line));
  for (const LaunchTransitions& one : description.transitions) {
    std::string line = "change " + named(description.processes[*one.process]) + ":";
    for (const std::int64_t transition : one.transitions) line += " " + label(transition);
    lines.push_back(line + at(one));
  }
  for (const LaunchEnd& one : description.ends)
    lines.push_back("end " + named(description.processes[one.process]) + at(one));
  for (const LaunchShutdown& one : description.shutdowns)
    lines.push_back("all ends: " + one.reason + at(one));
  for (const LaunchLeftOut& one : description.left_out)
    lines.push_back("skipped: " + one.what + " (" + one.instead + ")  [" + place(one.span) + "]");
  return lines;
}

std::string launch_json(const LaunchDescription& description) {
  JsonWriter json;
  json.begin_object().key("arguments").begin_array();
  for (const LaunchArgument& one : description.arguments) write_launch_argument(json, one);
  json.end_array().key("processes").begin_array();
  for (const LaunchProcess& process : description.processes) write_process(json, process);
  json.end_array().key("log").begin_array();
  for (const LaunchLine& line : description.lines) {
    json.begin_object().field("level", line.level).field("text", line.text);
    write_moment(json, line);
    json.end_object();
  }
  json.end_array();
  json.key("transitions").begin_array();
  for (const LaunchTransitions& one : description.transitions) {
    json.begin_object().field_integer("process", static_cast<std::int64_t>(*one.process));
    json.field("node", one.node).key("transitions").begin_array();
    for (const std::int64_t transition : one.transitions) json.integer(transition);
    json.end_array();
    write_moment(json, one);
    json.end_object();
  }
  json.end_array().key("ends").begin_array();
  for (const LaunchEnd& one : description.ends) {
    json.begin_object().field_integer("process", static_cast<std::int64_t>(one.process));
    write_moment(json, one);
    json.end_object();
  }
  json.end_array().key("shutdowns").begin_array();
  for (const LaunchShutdown& one : description.shutdowns) {
    json.begin_object().field("reason", one.reason);
    write_moment(json, one);
    json.end_object();
  }
  json.end_array();
  json.key("left_out").begin_array();
  for (const LaunchLeftOut& one : description.left_out) {
    json.begin_object().field("what", one.what).field("why", one.instead);
    write_place(json, one.span);
    json.end_object();
  }
  json.end_array();
  write_texts(json, "files", description.files);
  json.end_object();
  return json.text();
}

}  // namespace ros2wasm
