// See launch_tree.hpp. The keys of the JSON and their order are part of the format.
#include "bundler/launch/launch_tree.hpp"

#include <array>
#include <string_view>

#include "bundler/launch/node_arguments.hpp"
#include "workspace_schema/json_writer.hpp"

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

std::string program(const LaunchProcess& process) {
  return process.node.package.value + "/" + process.node.executable.value;
}

std::string when(const LaunchTrigger& trigger, const std::vector<LaunchProcess>& processes) {
  const LaunchProcess& other = processes[trigger.process];
  return "when " + program(other) + (other.node.name ? " " + node_label(other.node) : "") +
         (trigger.event == LaunchEvent::kExit ? " has ended" : " has started");
}

void add_process(const LaunchProcess& process, const std::vector<LaunchProcess>& processes,
                 Lines& lines) {
  const NodeEntry& node = process.node;
  std::string head = program(process);
  if (node.name) {
    head += "  " + node_label(node);
  } else if (node.name_space) {
    head += " (" + node.name_space->value + ")";
  }
  lines.push_back(head + "  [" + place(node.span) + "]");
  if (process.start_on) lines.push_back("  " + when(*process.start_on, processes));
  if (process.start_after_s > 0) lines.push_back("  after " + seconds(process.start_after_s));
  if (node.respawn)
    lines.push_back("  respawn" + (process.respawn_delay_s > 0
                                       ? " after " + seconds(process.respawn_delay_s)
                                       : std::string()));
  if (process.shutdown_on_exit) lines.emplace_back("  when it ends, all ends");
  for (const auto& [name, value] : process.environment)
    lines.push_back("  env " + name + "=" + value);
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

void write_argument(JsonWriter& json, const LaunchArgument& one) {
  json.begin_object().field("name", one.name).field("value", one.value);
  if (one.default_value) json.field("default", *one.default_value);
  json.field("description", one.description);
  write_texts(json, "choices", one.choices);
  write_place(json, one.span);
  json.end_object();
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
  json.field_integer("process", static_cast<std::int64_t>(trigger.process));
  json.field("event", trigger.event == LaunchEvent::kExit ? "exit" : "start").end_object();
}

void write_process(JsonWriter& json, const LaunchProcess& process) {
  const NodeEntry& node = process.node;
  json.begin_object()
      .field("package", node.package.value)
      .field("executable", node.executable.value);
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
  json.field_boolean("shutdown_on_exit", process.shutdown_on_exit);
  json.key("components").begin_array();
  for (const LaunchComponent& one : process.components) write_component(json, one);
  json.end_array();
  write_place(json, node.span);
  json.end_object();
}

}  // namespace

std::vector<std::string> launch_tree(const LaunchDescription& description) {
  Lines lines;
  add_arguments(description, lines);
  for (const LaunchProcess& process : description.processes)
    add_process(process, description.processes, lines);
  for (const LaunchLine& line : description.lines) {
    lines.push_back("log " + line.level + ": " + line.text +
                    (line.on ? "  " + when(*line.on, description.processes) : "") +
                    (line.after_s > 0 ? "  after " + seconds(line.after_s) : "") + "  [" +
                    place(line.span) + "]");
  }
  if (description.shutdown) {
    lines.push_back(
        "all ends " +
        (description.shutdown->on ? when(*description.shutdown->on, description.processes) + ", "
                                  : std::string()) +
        "after " + seconds(description.shutdown->after_s) +
        (description.shutdown->reason.empty() ? "" : ": " + description.shutdown->reason));
  }
  for (const LaunchLeftOut& one : description.left_out)
    lines.push_back("left out: " + one.what + " (" + one.instead + ")  [" + place(one.span) + "]");
  return lines;
}

std::string launch_json(const LaunchDescription& description) {
  JsonWriter json;
  json.begin_object().key("arguments").begin_array();
  for (const LaunchArgument& one : description.arguments) write_argument(json, one);
  json.end_array().key("processes").begin_array();
  for (const LaunchProcess& process : description.processes) write_process(json, process);
  json.end_array().key("log").begin_array();
  for (const LaunchLine& line : description.lines) {
    json.begin_object().field("level", line.level).field("text", line.text);
    if (line.on) write_trigger(json, "on", *line.on);
    json.key("after").number(line.after_s);
    write_place(json, line.span);
    json.end_object();
  }
  json.end_array();
  if (description.shutdown) {
    json.key("shutdown").begin_object();
    if (description.shutdown->on) write_trigger(json, "on", *description.shutdown->on);
    json.key("after").number(description.shutdown->after_s);
    json.field("reason", description.shutdown->reason).end_object();
  }
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
