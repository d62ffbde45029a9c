// See site_node_json.hpp. The keys and their order are part of the format.
#include "bundler/render/site_node_json.hpp"

#include "bundler/launch/launch_tree.hpp"

namespace ros2wasm {
namespace {

std::string_view output_name(NodeOutput output) {
  switch (output) {
    case NodeOutput::kScreen:
      return "screen";
    case NodeOutput::kLog:
      return "log";
    case NodeOutput::kBoth:
      return "both";
  }
  return "screen";
}

void write_moment(JsonWriter& json, const char* key, const LaunchMoment& moment) {
  json.key(key).begin_object();
  if (!moment.node.empty()) json.field("node", moment.node);
  json.field("event", launch_event_name(moment.event));
  if (!moment.name.empty()) json.field("name", moment.name);
  write_state_change(json, moment.change);
  write_output(json, moment.output);
  if (moment.once) json.field_boolean("once", true);
  if (moment.handler >= 0) json.field_integer("handler", moment.handler);
  json.end_object();
}

void write_step(JsonWriter& json, const LaunchStep& step) {
  json.begin_object();
  switch (step.kind) {
    case LaunchStepKind::kLog:
      json.field("do", "log").field("level", step.level).field("text", step.text);
      break;
    case LaunchStepKind::kShutdown:
      json.field("do", "shutdown").field("reason", step.text);
      break;
    case LaunchStepKind::kTransition:
      json.field("do", "transition").field("node", step.node).field("name", step.name);
      json.key("transitions").begin_array();
      for (const std::int64_t one : step.transitions) json.integer(one);
      json.end_array();
      break;
    case LaunchStepKind::kEnd:
      json.field("do", "end").field("node", step.node);
      break;
  }
  if (!step.on.node.empty() || step.on.event == LaunchEvent::kShutdown)
    write_moment(json, "on", step.on);
  if (step.after_s > 0) json.key("after").number(step.after_s);
  write_site_source(json, step.span);
  json.end_object();
}

/// The program of a node, however it is started.
void write_program(JsonWriter& json, const PlannedNode& planned) {
  if (planned.node.kind == ProgramKind::kCommand) {
    json.field("kind", "command");
    return;
  }
  json.field("kind", planned.script.empty() ? "cpp" : "python");
  json.field("program", planned.program);
  if (!planned.script.empty()) {
    json.key("python").begin_object().key("archives").begin_array();
    for (const std::string& archive : planned.archives) json.string(archive);
    json.end_array();
    if (!planned.load.empty()) {
      json.key("libraries").begin_array();
      for (const std::string& path : planned.load) json.string(path);
      json.end_array();
    }
    json.field("entry", planned.script).end_object();
  }
  if (!planned.names.empty()) json.field("names", planned.names);
  json.field_boolean("threads", planned.threads);
}

}  // namespace

void write_site_source(JsonWriter& json, const SourceSpan& source) {
  if (source.file.empty()) return;
  json.key("source").begin_object().field("file", source.file);
  json.field_integer("line", source.line).field_integer("column", source.column).end_object();
}

void write_site_program(JsonWriter& json, const PlannedNode& planned) {
  json.begin_object().field("package", planned.node.package);
  json.field("executable", planned.node.executable);
  write_program(json, planned);
  json.end_object();
}

void write_site_node(JsonWriter& json, const PlannedNode& planned) {
  const LaunchNode& node = planned.node;
  json.begin_object().field("id", node.id).field("package", node.package);
  json.field("executable", node.executable).field("label", node.label);
  write_program(json, planned);
  json.key("arguments").begin_array();
  for (const std::string& argument : node.arguments) json.string(argument);
  json.end_array();
  json.key("environment").begin_object();
  for (const auto& [name, value] : node.environment) json.field(name, value);
  json.end_object();
  json.field("output", output_name(node.output)).field_boolean("respawn", node.respawn);
  if (node.respawn_delay_s > 0) json.key("respawn_delay").number(node.respawn_delay_s);
  if (node.respawn_max_retries)
    json.field_integer("respawn_max_retries", *node.respawn_max_retries);
  if (!node.start_on.node.empty()) write_moment(json, "start_on", node.start_on);
  if (node.start_after_s > 0) json.key("start_after").number(node.start_after_s);
  if (node.shutdown_on_exit) json.field("on_exit", "shutdown");
  write_site_source(json, node.source);
  json.end_object();
}

void write_launch_steps(JsonWriter& json, const std::vector<LaunchStep>& steps) {
  json.key("steps").begin_array();
  for (const LaunchStep& step : steps) write_step(json, step);
  json.end_array();
}

}  // namespace ros2wasm
