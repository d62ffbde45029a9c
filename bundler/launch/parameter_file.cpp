// See parameter_file.hpp.
#include "bundler/launch/parameter_file.hpp"

#include <algorithm>
#include <optional>

#include "bundler/launch/launch_values.hpp"
#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kParametersKey = "ros__parameters";

/// A scalar as ROS 2 types it; nothing when it has no type that parameters can have.
std::optional<ParameterValue> typed(const YamlNode& node) {
  const bool is_letter =
      node.text == "t" || node.text == "T" || node.text == "f" || node.text == "F";
  if (is_old_boolean(node) && is_letter) return ParameterValue(node.text);
  if (is_old_boolean(node)) {
    const char first = node.text.front();
    const bool on =
        first == 'y' || first == 'Y' || node.text == "on" || node.text == "On" || node.text == "ON";
    return ParameterValue(on);
  }
  const YamlValue value = scalar_value(node);
  if (const auto* one = std::get_if<bool>(&value)) return ParameterValue(*one);
  if (const auto* one = std::get_if<std::int64_t>(&value)) return ParameterValue(*one);
  if (const auto* one = std::get_if<double>(&value)) return ParameterValue(*one);
  if (const auto* one = std::get_if<std::string>(&value)) return ParameterValue(*one);
  return std::nullopt;
}

bool same_type(const std::vector<ParameterValue>& items) {
  return std::all_of(items.begin(), items.end(), [&](const ParameterValue& item) {
    return item.index() == items.front().index();
  });
}

/// `ros_parameters`, `ros__parameter`, `ros___parameters`: no node is called so.
bool is_misspelt(std::string_view key) {
  std::string letters;
  for (const char c : key)
    if (c != '_' && c != '-') letters += c;
  return key != kParametersKey && (letters == "rosparameters" || letters == "rosparameter");
}

class Reader {
 public:
  explicit Reader(const SourceText& source) : source_(source) {}

  void nodes(const YamlNode& node, const std::string& name) {
    if (node.kind != YamlKind::kMap) {
      fail(node.range,
           "expected node names and `ros__parameters`, found " + std::string(described(node)));
      return;
    }
    for (const YamlEntry& entry : node.entries) {
      if (is_misspelt(entry.key)) {
        fail(entry.key_range, "`" + entry.key + "` is not a key of parameter files");
        errors_.back().label = "two underscores: `ros__parameters`";
        errors_.back().fix.emplace_back("ros__parameters:");
      } else if (entry.key != kParametersKey) {
        const bool joins = name.empty() || entry.key.starts_with('/') || name.ends_with('/');
        nodes(entry.value, name + (joins ? "" : "/") + entry.key);
      } else if (name.empty()) {
        fail(entry.key_range, "`ros__parameters` must stand below a node's name");
      } else if (entry.value.kind == YamlKind::kMap) {
        parameters(entry.value, name.starts_with('/') ? name : "/" + name, "");
      } else if (entry.value.kind != YamlKind::kNull) {
        fail(entry.value.range, "`ros__parameters` must have parameters below it");
      }
    }
  }

  [[nodiscard]] Diagnostics& errors() { return errors_; }
  [[nodiscard]] std::vector<ParameterRule>& rules() { return rules_; }

 private:
  void parameters(const YamlNode& map, const std::string& pattern, const std::string& prefix) {
    for (const YamlEntry& entry : map.entries) {
      const std::string name = prefix + entry.key;
      if (entry.value.kind == YamlKind::kMap) {
        parameters(entry.value, pattern, name + ".");
      } else if (const auto value = value_of(entry.value, name)) {
        rules_.push_back({.pattern = pattern, .name = name, .value = parameter_text(*value)});
      }
    }
  }

  std::optional<ParameterValue> value_of(const YamlNode& node, const std::string& name) {
    if (node.kind != YamlKind::kSequence) {
      auto value = typed(node);
      if (!value) fail(node.range, "parameter `" + name + "` has no value that ROS 2 knows");
      return value;
    }
    std::vector<ParameterValue> items;
    for (const YamlNode& item : node.items) {
      auto value = item.kind == YamlKind::kScalar ? typed(item) : std::nullopt;
      if (!value) {
        fail(item.range, "parameter `" + name + "`: lists hold numbers, texts or booleans only");
        return std::nullopt;
      }
      items.push_back(std::move(*value));
    }
    // Unlike launch, rcl takes no whole numbers among others.
    auto list = same_type(items) ? list_parameter(items) : std::nullopt;
    if (!list)
      fail(node.range, "parameter `" + name + "`: all items of a list must have the same type");
    return list;
  }

  void fail(TextRange range, const std::string& message) {
    errors_.push_back(Diagnostic{
        .code = "R2W0403", .message = message, .span = source_.span(range.offset, range.length)});
  }

  const SourceText& source_;
  std::vector<ParameterRule> rules_;
  Diagnostics errors_;
};

}  // namespace

std::optional<ParameterValue> parameter_value(const YamlNode& node) {
  if (node.kind == YamlKind::kNull) return ParameterValue(std::string());
  if (node.kind == YamlKind::kScalar) return typed(node);
  if (node.kind != YamlKind::kSequence) return std::nullopt;
  std::vector<ParameterValue> items;
  for (const YamlNode& item : node.items) {
    auto value = item.kind == YamlKind::kScalar ? typed(item) : std::nullopt;
    if (!value) return std::nullopt;
    items.push_back(std::move(*value));
  }
  return list_parameter(items);
}

Outcome<std::vector<ParameterRule>> read_parameter_file(std::string_view text,
                                                        const std::string& file) {
  const SourceText source(text, file);
  auto document = parse_yaml(source);
  if (!document) {
    Diagnostics errors = std::move(document).errors();
    for (Diagnostic& error : errors) error.code = "R2W0403";
    return errors;
  }
  Reader reader(source);
  if (document->root.kind != YamlKind::kNull) reader.nodes(document->root, "");
  for (Diagnostic& problem : document->problems) {
    problem.code = "R2W0403";
    reader.errors().push_back(std::move(problem));
  }
  if (!reader.errors().empty()) return std::move(reader.errors());
  return std::move(reader.rules());
}

}  // namespace ros2wasm
