// See check_json.hpp. The keys and their order are part of the format.
#include "workspace_schema/schema/check_json.hpp"

#include "workspace_schema/schema/manifest_json.hpp"

namespace ros2wasm {
namespace {

std::string_view state_word(CheckedState state) {
  switch (state) {
    case CheckedState::kRunning:
      return "running";
    case CheckedState::kExited:
      return "exited";
    case CheckedState::kCrashed:
      return "crashed";
  }
  return "running";
}

struct FieldWriter {
  JsonWriter& json;

  void bounds(const std::optional<double>& above, const std::optional<double>& below) const {
    if (above) json.key("above").number(*above);
    if (below) json.key("below").number(*below);
  }

  void value(const Comparison& value) const {
    bounds(value.above, value.below);
    if (value.equals) write_parameter(json.key("equals"), *value.equals);
    if (!value.matches.empty()) json.field("matches", value.matches);
  }

  void operator()(const RateCheck& check) const {
    json.field("kind", "rate").field("topic", check.topic);
    bounds(check.above_hz, check.below_hz);
  }

  void operator()(const MessageCheck& check) const {
    json.field("kind", "message").field("topic", check.topic).field("field", check.field);
    value(check.value);
  }

  void operator()(const LogCheck& check) const {
    json.field("kind", "log");
    if (check.node) json.field("node", check.node->value);
    json.field("log", check.pattern);
  }

  void operator()(const ParameterCheck& check) const {
    json.field("kind", "parameter").field("node", check.node).field("parameter", check.name);
    value(check.value);
  }

  void operator()(const StateCheck& check) const {
    json.field("kind", "state").field("node", check.node.value);
    json.field("state", state_word(check.state));
  }

  void operator()(const ExitCheck& check) const {
    json.field("kind", "exit_code").field("node", check.node.value);
    json.field_integer("exit_code", check.code);
  }
};

}  // namespace

void write_check_aim(JsonWriter& json, const CheckEntry& check) {
  if (!check.title.empty()) json.field("title", check.title);
  std::visit(FieldWriter{json}, check.what);
}

void write_check_fields(JsonWriter& json, const CheckEntry& check) {
  write_check_aim(json, check);
  json.field_integer("within_ms", check.within_ms);
}

void write_task_texts(JsonWriter& json, const TaskEntry& task) {
  json.field("title", task.title.value);
  for (const auto& [key, text] : {std::pair("text", &task.text), std::pair("hint", &task.hint),
                                  std::pair("solution", &task.solution)})
    if (!text->empty()) json.field(key, *text);
}

}  // namespace ros2wasm
