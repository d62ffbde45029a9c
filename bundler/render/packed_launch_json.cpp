// See packed_launch_json.hpp. The keys are read by bundler/render/launch_start.cpp.
#include "bundler/render/packed_launch_json.hpp"

#include "bundler/launch/node_arguments.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

constexpr int kLaunchSchema = 1;

std::string_view kind_name(ProgramKind kind) {
  switch (kind) {
    case ProgramKind::kNone:
      return "none";
    case ProgramKind::kWasm:
      return "cpp";
    case ProgramKind::kPython:
      return "python";
    case ProgramKind::kCommand:
      return "command";
  }
  return "none";
}

void write_map(JsonWriter& json, const char* key, const std::map<std::string, std::string>& texts) {
  json.key(key).begin_object();
  for (const auto& [name, text] : texts) json.field(name, text);
  json.end_object();
}

const PlannedNode* planned_for(const InstalledProgram& program,
                               const std::vector<PlannedNode>& programs) {
  for (const PlannedNode& one : programs)
    if (one.node.package == program.package &&
        one.node.program.filename() == program.file.filename())
      return &one;
  return nullptr;
}

void write_program(JsonWriter& json, const InstalledProgram& program,
                   const std::vector<PlannedNode>& programs) {
  json.begin_object().field("executable", program.executable);
  json.field("file", program.file.filename().string()).field("kind", kind_name(program.kind));
  if (!program.left_out.empty()) json.field("left_out", program.left_out);
  if (const PlannedNode* planned = planned_for(program, programs)) {
    json.field("program", planned->program);
    if (!planned->names.empty()) json.field("names", planned->names);
    if (!planned->script.empty()) json.field("script", planned->script);
    json.field_boolean("threads", planned->threads).key("archives").begin_array();
    for (const std::string& archive : planned->archives) json.string(archive);
    json.end_array();
  }
  json.end_object();
}

}  // namespace

std::string packed_launch_json(const PackedLaunch& launch,
                               const std::vector<PlannedNode>& programs) {
  JsonWriter json;
  json.begin_object().field_integer("schema", kLaunchSchema).field("file", launch.file);
  json.key("from").begin_object().field("file", launch.from.file);
  json.field_integer("line", launch.from.line).field_integer("column", launch.from.column);
  json.end_object().field("distro", launch.distro);
  write_map(json, "given", launch.given);
  if (!launch.variables.empty()) write_map(json, "variables", launch.variables);
  write_map(json, "texts", launch.texts);
  json.key("packages").begin_array();
  for (const InstalledPackage& package : launch.installed) {
    json.begin_object().field("name", package.name).field("version", package.version);
    json.key("programs").begin_array();
    for (const InstalledProgram& program : package.programs) write_program(json, program, programs);
    json.end_array().end_object();
  }
  json.end_array().key("left_out").begin_object();
  for (const auto& [name, chain] : launch.left_out) {
    json.key(name).begin_array();
    for (const std::string& one : chain) json.string(one);
    json.end_array();
  }
  json.end_object().key("python");
  write_python_exchanges(json, launch.python);
  return json.end_object().text() + "\n";
}

}  // namespace ros2wasm
