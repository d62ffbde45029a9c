// See diagnostic_json.hpp. Places are not carried: the link driver knows none.
#include "bundler/build/diagnostic_json.hpp"

#include "workspace_schema/json_reader.hpp"
#include "workspace_schema/json_writer.hpp"

namespace ros2wasm {
namespace {

void write_lines(JsonWriter& json, std::string_view name, const std::vector<std::string>& lines) {
  json.key(name).begin_array();
  for (const std::string& line : lines) json.string(line);
  json.end_array();
}

std::vector<std::string> read_lines(const JsonValue* value) {
  std::vector<std::string> result;
  if (value == nullptr) return result;
  for (const JsonValue& item : value->items()) {
    if (const std::string* text = item.string()) result.push_back(*text);
  }
  return result;
}

}  // namespace

std::string diagnostics_to_json(const Diagnostics& diagnostics) {
  JsonWriter json;
  json.begin_array();
  for (const Diagnostic& one : diagnostics) {
    json.begin_object().field("code", one.code).field_integer("kind", static_cast<int>(one.kind));
    json.field("message", one.message).field("detail", one.detail);
    write_lines(json, "why", one.why);
    write_lines(json, "fix", one.fix);
    json.end_object();
  }
  json.end_array();
  return json.text();
}

Diagnostics diagnostics_from_json(std::string_view text) {
  Diagnostics result;
  const auto json = parse_json(text, "link diagnostics", "R2W0505");
  if (!json) return result;
  for (const JsonValue& item : json->items()) {
    const JsonValue* kind = item.find("kind");
    const auto number = kind == nullptr ? std::nullopt : kind->integer();
    result.push_back(
        Diagnostic{.code = item.text_of("code"),
                   .kind = number ? static_cast<FailureKind>(*number) : FailureKind::kUserInput,
                   .message = item.text_of("message"),
                   .why = read_lines(item.find("why")),
                   .fix = read_lines(item.find("fix")),
                   .detail = item.text_of("detail")});
  }
  return result;
}

}  // namespace ros2wasm
