// See launch_python.hpp. The messages are described in ros2wasm_launch/reader.py.
#include "bundler/launch/launch_python.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

constexpr DiagnosticCode kCode = "R2W0416";
constexpr const char* kTalk = "what Python says of a launch file";
constexpr int kDeepest = 64;

using Texts = std::map<std::string, std::string>;

void write_texts(JsonWriter& json, const char* key, const Texts& texts) {
  json.key(key).begin_object();
  for (const auto& [name, value] : texts) json.field(name, value);
  json.end_object();
}

Texts read_texts(const JsonValue& json, std::string_view key) {
  Texts result;
  if (const JsonValue* object = json.find(key)) {
    for (const auto& [name, value] : object->members())
      if (const std::string* text = value.string()) result[name] = *text;
  }
  return result;
}

std::uint32_t line_of(const JsonValue& json) {
  const JsonValue* line = json.find("line");
  return line == nullptr ? 0 : static_cast<std::uint32_t>(line->integer().value_or(0));
}

SourceSpan whole_line(std::string file, std::uint32_t line, std::string text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  return {.file = std::move(file),
          .line = line,
          .column = text.empty() ? 0 : static_cast<std::uint32_t>(begin + 1),
          .length = static_cast<std::uint32_t>(text.size() - begin),
          .line_text = std::move(text)};
}

/// As Python's json reads it back as a float.
std::string python_number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  std::string text = JsonWriter().number(value).text();
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

void write_yaml(JsonWriter& json, const YamlNode& node) {
  if (node.kind == YamlKind::kMap) {
    json.begin_object();
    for (const YamlEntry& entry : node.entries) {
      json.key(entry.key);
      write_yaml(json, entry.value);
    }
    json.end_object();
  } else if (node.kind == YamlKind::kSequence) {
    json.begin_array();
    for (const YamlNode& item : node.items) write_yaml(json, item);
    json.end_array();
  } else {
    const YamlValue value = scalar_value(node);
    if (const auto* flag = std::get_if<bool>(&value)) {
      json.boolean(*flag);
    } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
      json.integer(*whole);
    } else if (const auto* real = std::get_if<double>(&value)) {
      json.raw_number(python_number(*real));
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      json.string(*text);
    } else {
      json.null();
    }
  }
}

std::string refusal(const std::string& why) {
  return JsonWriter().begin_object().field("error", why).end_object().text();
}

std::string refusal(const Diagnostics& errors) {
  std::string why = errors.front().message;
  for (const std::string& more : errors.front().why) why += "; " + more;
  return refusal(why);
}

/// Answers a question that Python asks while it runs.
std::string reply(const std::string& text, const PythonMoment& moment) {
  const auto asked = parse_json(text, kTalk, kCode);
  if (!asked) return refusal(asked.errors());
  const std::string kind = asked->text_of("ask");
  if (kind == "evaluate") {
    LaunchScope scope = moment.scope;
    scope.configurations = read_texts(*asked, "configurations");
    const auto parsed = parse_launch_text(asked->text_of("text"), moment.span);
    const auto result = parsed
                            ? evaluate_text(*parsed, moment.span, scope, moment.file, moment.world)
                            : Outcome<std::string>(parsed.errors());
    if (!result) return refusal(result.errors());
    return JsonWriter().begin_object().field("text", *result).end_object().text();
  }
  if (kind == "yaml") {
    const std::string yaml = asked->text_of("text");
    const SourceText source(yaml, "YAML");
    const auto document = parse_yaml(source);
    if (!document) return refusal(document.errors());
    if (!document->problems.empty()) return refusal(document->problems);
    JsonWriter json;
    json.begin_object().key("value");
    write_yaml(json, document->root);
    return json.end_object().text();
  }
  if (kind == "log" && moment.said) {
    moment.said({.level = asked->text_of("level"),
                 .text = asked->text_of("text"),
                 .span = {.file = moment.world.shown_path(asked->text_of("file")),
                          .line = line_of(*asked),
                          .line_text = {}}});
  }
  return "{}";
}

Diagnostic failure(const JsonValue& error, const PythonMoment& moment) {
  const std::string file = error.text_of("file");
  const std::string kind = error.text_of("kind");
  const std::string message = error.text_of("message");
  Diagnostic result{
      .code = kCode,
      .message = "the launch file fails: " + (kind.empty() ? message : kind + ": " + message),
      .span = whole_line(moment.world.shown_path(file), line_of(error), error.text_of("text"))};
  if (file.empty()) result.span = moment.span;
  if (error.find("module") != nullptr) {
    result.message = "the launch file imports what is not there: " + message;
    result.why = {
        "it can import launch, launch_ros, launch_xml, launch_yaml, nav2_common.launch, "
        "ament_index_python, xacro, yaml, Python's own modules, and those of the workspace's "
        "packages; rclpy and messages for their types",
        "what else it makes can be written down in its place: a parameter file, a URDF"};
  }
  if (const std::string name = error.text_of("variable"); !name.empty()) {
    result.message = "the launch file needs the environment variable `" + name + "`";
    result.why = {"a site is packed the same on every machine, so the machine's own are not seen"};
    result.fix = {"in workspace.yaml: " + variable_in_manifest(name),
                  "in the launch file: os.environ.get('" + name + "', ...), or a launch argument"};
  }
  if (const JsonValue* callers = error.find("callers"))
    for (const JsonValue& one : callers->items())
      result.why.push_back("called from " + moment.world.shown_path(one.text_of("file")) + ":" +
                           std::to_string(line_of(one)) + ", in " + one.text_of("name"));
  return result;
}

/// The common frame of requests: what is asked, and where the evaluation is.
JsonWriter request(const char* what, const PythonMoment& moment) {
  JsonWriter json;
  json.begin_object().field("do", what);
  write_texts(json, "configurations", moment.scope.configurations);
  Texts environment = moment.scope.environment;
  environment.insert(moment.world.environment.begin(), moment.world.environment.end());
  write_texts(json, "environment", environment);
  return json;
}

Outcome<JsonValue> asked(const JsonWriter& request, const PythonMoment& moment) {
  if (!moment.world.python) {
    return Diagnostic{.code = kCode,
                      .message = "launch files in Python cannot be read here",
                      .span = moment.span};
  }
  const auto answer = moment.world.python(
      request.text(), [&](const std::string& text) { return reply(text, moment); });
  if (!answer) return answer.errors();
  auto json = parse_json(*answer, kTalk, kCode);
  if (!json) return std::move(json).errors();
  if (const JsonValue* error = json->find("error")) return failure(*error, moment);
  return json;
}

/// Makes entities of JSON; notes what is not one.
class Entities {
 public:
  explicit Entities(const LaunchWorld& world) : world_(world) {}

  LaunchEntity entity(const JsonValue& json, int depth = 0) {
    LaunchEntity result{.tag = json.text_of("tag"),
                        .span = span(json.text_of("file"), line_of(json)),
                        .attributes = {},
                        .children = {}};
    if (const JsonValue* attributes = json.find("attributes")) {
      for (const auto& [name, value] : attributes->members())
        result.attributes.push_back({.name = name, .value = attribute(value), .span = result.span});
    }
    if (depth > kDeepest) return result;
    if (const JsonValue* children = json.find("children"))
      for (const JsonValue& child : children->items())
        result.children.push_back(entity(child, depth + 1));
    return result;
  }

 private:
  static LaunchScalar scalar(const JsonValue& json) {
    if (const auto flag = json.boolean()) return *flag;
    if (const std::string* text = json.string()) return *text;
    JsonValue copy = json;
    if (const auto* real = std::get_if<double>(&copy.state())) return *real;
    if (const auto whole = json.integer()) return *whole;
    return json.number().value_or(0);
  }

  static LaunchAttributeValue attribute(const JsonValue& json) {
    if (!json.is_array())
      return std::visit([](auto held) { return LaunchAttributeValue(std::move(held)); },
                        scalar(json));
    std::vector<LaunchScalar> items;
    for (const JsonValue& item : json.items()) items.push_back(scalar(item));
    return items;
  }

  SourceSpan span(const std::string& file, std::uint32_t line) {
    const auto& lines = lines_of(file);
    return whole_line(file.empty() ? "" : world_.shown_path(file), line,
                      line > 0 && line <= lines.size() ? lines[line - 1] : "");
  }

  const std::vector<std::string>& lines_of(const std::string& file) {
    const auto [entry, is_new] = lines_.try_emplace(file);
    if (!is_new || file.empty()) return entry->second;
    const auto text = world_.read(file);
    std::size_t begin = 0;
    while (text && begin < text->size()) {
      const std::size_t end = std::min(text->find('\n', begin), text->size());
      entry->second.push_back(text->substr(begin, end - begin));
      begin = end + 1;
    }
    return entry->second;
  }

  const LaunchWorld& world_;
  std::map<std::string, std::vector<std::string>> lines_;
};

PythonActions actions_of(const JsonValue& answer, const PythonMoment& moment) {
  PythonActions result;
  if (const JsonValue* root = answer.find("entity"))
    result.root = Entities(moment.world).entity(*root);
  result.configurations = answer.find("configurations") != nullptr
                              ? read_texts(answer, "configurations")
                              : moment.scope.configurations;
  result.environment = read_texts(answer, "environment");
  if (const JsonValue* unset = answer.find("unset"))
    for (const JsonValue& name : unset->items())
      if (const std::string* text = name.string()) result.unset.push_back(*text);
  return result;
}

}  // namespace

Outcome<PythonActions> load_python_launch(const std::string& path, const PythonMoment& moment) {
  const auto answer = asked(request("load", moment).field("path", path).end_object(), moment);
  if (!answer) return answer.errors();
  return actions_of(*answer, moment);
}

Outcome<PythonActions> call_python_launch(std::int64_t number, const PythonMoment& moment) {
  const auto answer =
      asked(request("call", moment).field_integer("number", number).end_object(), moment);
  if (!answer) return answer.errors();
  return actions_of(*answer, moment);
}

Outcome<std::string> perform_python(std::int64_t number, const PythonMoment& moment) {
  const auto answer =
      asked(request("perform", moment).field_integer("number", number).end_object(), moment);
  if (!answer) return answer.errors();
  return answer->text_of("text");
}

Outcome<std::string> read_python_file(const std::string& path, const LaunchWorld& world) {
  const LaunchScope scope;
  const LaunchFilePlace file{.path = path};
  const SourceSpan span;
  const PythonMoment moment{.scope = scope, .file = file, .world = world, .span = span};
  const auto answer = asked(request("read", moment).field("path", path).end_object(), moment);
  if (!answer) return answer.errors();
  return answer->text_of("text");
}

}  // namespace ros2wasm
