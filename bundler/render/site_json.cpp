// See site_json.hpp. The keys and their order are part of the format.
#include "bundler/render/site_json.hpp"

#include "workspace_schema/check_json.hpp"
#include "workspace_schema/json_writer.hpp"

namespace ros2wasm {
namespace {

constexpr int kSiteSchema = 1;
constexpr int kProtocol = 1;

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

void write_source(JsonWriter& json, const SourceSpan& source) {
  if (source.file.empty()) return;
  json.key("source").begin_object().field("file", source.file);
  json.field_integer("line", source.line).field_integer("column", source.column).end_object();
}

void write_moment(JsonWriter& json, const char* key, const LaunchMoment& moment) {
  json.key(key).begin_object();
  if (!moment.node.empty()) json.field("node", moment.node);
  json.field("event", launch_event_name(moment.event));
  if (!moment.name.empty()) json.field("name", moment.name);
  write_state_change(json, moment.change);
  if (moment.once) json.field_boolean("once", true);
  json.end_object();
}

void write_node(JsonWriter& json, const PlannedNode& planned) {
  const LaunchNode& node = planned.node;
  json.begin_object().field("id", node.id).field("package", node.package);
  json.field("executable", node.executable).field("label", node.label);
  json.field("kind", planned.script.empty() ? "cpp" : "python");
  json.field("program", planned.program);
  if (!planned.script.empty()) {
    json.key("python").begin_object().key("archives").begin_array();
    for (const std::string& archive : planned.archives) json.string(archive);
    json.end_array().field("entry", planned.script).end_object();
  }
  if (!planned.names.empty()) json.field("names", planned.names);
  json.field_boolean("threads", planned.threads);
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
  write_source(json, node.source);
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
  }
  if (!step.on.node.empty() || step.on.event == LaunchEvent::kShutdown)
    write_moment(json, "on", step.on);
  if (step.after_s > 0) json.key("after").number(step.after_s);
  write_source(json, step.span);
  json.end_object();
}

void write_checks(JsonWriter& json, const std::vector<CheckEntry>& checks) {
  if (checks.empty()) return;
  json.key("checks").begin_array();
  for (const CheckEntry& check : checks) {
    json.begin_object();
    write_check_fields(json, check);
    write_source(json, check.span);
    json.end_object();
  }
  json.end_array();
}

void write_options(JsonWriter& json, std::string_view name,
                   const std::map<std::string, std::string>& options) {
  json.key(name).begin_object();
  for (const auto& [key, value] : options) {
    if (value == "true" || value == "false") {
      json.field_boolean(key, value == "true");
    } else {
      json.field(key, value);
    }
  }
  json.end_object();
}

}  // namespace

std::string site_json(const Manifest& manifest, const SitePlan& plan) {
  JsonWriter json;
  json.begin_object().field_integer("schema", kSiteSchema).field_integer("protocol", kProtocol);
  json.field("generator", std::string(kSiteGenerator) + " " ROS2WASM_VERSION);
  json.field("name", manifest.name.value);
  json.field("title", manifest.title.empty() ? manifest.name.value : manifest.title);
  json.field("version", manifest.version)
      .field("distro", manifest.distro)
      .field("license", manifest.license);
  json.key("authors").begin_array();
  for (const Author& author : manifest.authors) {
    json.begin_object().field("name", author.name);
    if (!author.email.empty()) json.field("email", author.email);
    if (!author.orcid.empty()) json.field("orcid", author.orcid);
    if (!author.affiliation.empty()) json.field("affiliation", author.affiliation);
    json.end_object();
  }
  json.end_array();
  json.key("nodes").begin_array();
  for (const PlannedNode& node : plan.nodes) write_node(json, node);
  json.end_array();
  if (!plan.steps.empty()) {
    json.key("launch").begin_object().key("steps").begin_array();
    for (const LaunchStep& step : plan.steps) write_step(json, step);
    json.end_array().end_object();
  }
  json.field("interfaces", "interfaces.json");
  json.key("packages").begin_array();
  for (const std::string& package : plan.packages) json.string(package);
  json.end_array();
  write_checks(json, plan.checks);
  write_options(json, "ui", manifest.ui);
  json.key("files").begin_array();
  for (const PlannedFile& file : plan.files) {
    json.begin_object().field("path", file.path);
    json.key("size").unsigned_integer(file.bytes.size());
    json.field("sha256", file.sha256).field("reason", file.reason).end_object();
  }
  json.end_array().end_object();
  return json.text() + "\n";
}

}  // namespace ros2wasm
