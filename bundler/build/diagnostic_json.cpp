// See diagnostic_json.hpp.
#include "bundler/build/diagnostic_json.hpp"

#include <optional>

#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"

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

std::uint32_t number_of(const JsonValue& object, std::string_view name) {
  const JsonValue* value = object.find(name);
  const auto number = value == nullptr ? std::nullopt : value->integer();
  return number && *number > 0 ? static_cast<std::uint32_t>(*number) : 0;
}

void write_span(JsonWriter& json, const SourceSpan& span) {
  json.key("span").begin_object().field("file", span.file);
  json.field_integer("line", span.line).field_integer("column", span.column);
  json.field_integer("length", span.length).field("line_text", span.line_text).end_object();
}

std::optional<SourceSpan> read_span(const JsonValue* value) {
  if (value == nullptr) return std::nullopt;
  return SourceSpan{.file = value->text_of("file"),
                    .line = number_of(*value, "line"),
                    .column = number_of(*value, "column"),
                    .length = number_of(*value, "length"),
                    .line_text = value->text_of("line_text")};
}

void write_diagnostics(JsonWriter& json, const Diagnostics& diagnostics) {
  json.begin_array();
  for (const Diagnostic& one : diagnostics) {
    json.begin_object().field("code", one.code).field_integer("kind", static_cast<int>(one.kind));
    json.field_integer("severity", static_cast<int>(one.severity));
    json.field("message", one.message).field("label", one.label).field("detail", one.detail);
    if (one.span) write_span(json, *one.span);
    write_lines(json, "why", one.why);
    write_lines(json, "fix", one.fix);
    json.end_object();
  }
  json.end_array();
}

Diagnostics read_diagnostics(const JsonValue& json) {
  Diagnostics result;
  for (const JsonValue& item : json.items()) {
    const JsonValue* kind = item.find("kind");
    const auto number = kind == nullptr ? std::nullopt : kind->integer();
    result.push_back(
        Diagnostic{.code = DiagnosticCode::of_text(item.text_of("code")),
                   .severity = static_cast<Severity>(number_of(item, "severity")),
                   .kind = number ? static_cast<FailureKind>(*number) : FailureKind::kUserInput,
                   .message = item.text_of("message"),
                   .span = read_span(item.find("span")),
                   .label = item.text_of("label"),
                   .why = read_lines(item.find("why")),
                   .fix = read_lines(item.find("fix")),
                   .detail = item.text_of("detail")});
  }
  return result;
}

}  // namespace

std::string diagnostics_to_json(const Diagnostics& diagnostics) {
  JsonWriter json;
  write_diagnostics(json, diagnostics);
  return json.text();
}

Diagnostics diagnostics_from_json(std::string_view text) {
  const auto json = parse_json(text, "findings of a build", "R2W0505");
  return json ? read_diagnostics(*json) : Diagnostics();
}

std::string link_findings_to_json(const LinkFindings& findings) {
  JsonWriter json;
  json.begin_object().field("output", findings.output).field("program", findings.program);
  json.key("diagnostics");
  write_diagnostics(json, findings.diagnostics);
  json.end_object();
  return json.text();
}

LinkFindings link_findings_from_json(std::string_view text) {
  const auto json = parse_json(text, "findings of a link", "R2W0505");
  if (!json) return {};
  const JsonValue* diagnostics = json->find("diagnostics");
  return {.output = json->text_of("output"),
          .program = json->text_of("program"),
          .diagnostics = diagnostics == nullptr ? Diagnostics() : read_diagnostics(*diagnostics)};
}

}  // namespace ros2wasm
