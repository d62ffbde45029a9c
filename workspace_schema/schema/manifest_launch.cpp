// See manifest_launch.hpp.
#include "workspace_schema/schema/manifest_launch.hpp"

#include <algorithm>
#include <string_view>

#include "workspace_schema/base/yaml_scalar.hpp"
#include "workspace_schema/schema/manifest_nodes.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kWanted = "a launch file or a list of nodes";

/// A mapping with these is a node, or nodes, that lack the list around them.
bool looks_like_nodes(const YamlNode& node) {
  constexpr std::string_view kKeys[] = {"executable", "node", "nodes", "package"};
  return std::any_of(std::begin(kKeys), std::end(kKeys),
                     [&](std::string_view key) { return value_of(node, key) != nullptr; });
}

/// Any text, which may be empty, or a number or boolean as it is written: what stands behind `:=`.
std::optional<std::string> argument_value(Binder& binder, const YamlEntry& entry) {
  const YamlValue value = scalar_value(entry.value);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (std::holds_alternative<bool>(value)) return entry.value.text;
  if (const auto written = binder.written(entry.value, entry.key)) return written->value;
  return std::nullopt;
}

void read_arguments(Binder& binder, const YamlNode& node, Manifest& manifest) {
  if (node.kind == YamlKind::kNull) return;
  if (node.kind != YamlKind::kMap) {
    Diagnostic& wrong = binder.wrong_type(node, "arguments", "a mapping from names to values");
    const std::size_t sign = node.text.find(":=");
    if (node.kind == YamlKind::kScalar && sign != std::string::npos && sign > 0 &&
        node.text.find_first_of(" \t\n") == std::string::npos)
      wrong.fix.push_back("write `arguments: {" + as_yaml_text(node.text.substr(0, sign)) + ": " +
                          as_yaml_text(node.text.substr(sign + 2)) + "}`");
    return;
  }
  for (const YamlEntry& entry : node.entries) {
    auto value = argument_value(binder, entry);
    if (!value) continue;
    manifest.launch_arguments.push_back(
        {.name = {.value = entry.key, .span = binder.span(entry.key_range)},
         .value = std::move(*value)});
  }
}

/// As shells and ROS take them.
bool is_variable_name(const std::string& name) {
  const auto is_letter = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
  };
  return !name.empty() && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

void read_variables(Binder& binder, const YamlNode& node, Manifest& manifest) {
  if (node.kind == YamlKind::kNull) return;
  if (node.kind != YamlKind::kMap) {
    binder.wrong_type(node, "environment", "a mapping from variables to values");
    return;
  }
  for (const YamlEntry& entry : node.entries) {
    if (!is_variable_name(entry.key)) {
      binder.error("R2W0103", "`" + entry.key + "` is not the name of an environment variable",
                   entry.key_range, "letters, digits and underscores, no digit first");
      continue;
    }
    if (auto value = argument_value(binder, entry))
      manifest.launch_variables[entry.key] = std::move(*value);
  }
}

void read_file(Binder& binder, const YamlNode& node, Manifest& manifest) {
  static const std::vector<KeyRow> kKeys{
      {"file", {"launch_file", "path"}},
      {"arguments", {"args", "launch_arguments", "parameters"}},
      {"environment", {"env", "environ", "variables"}},
  };
  binder.mapping(node, "`launch` with a launch file", kKeys);
  if (const YamlNode* file = value_of(node, "file")) {
    if (auto path = binder.path(*file, "file")) manifest.launch_file = *std::move(path);
  } else {
    binder.missing(node, "`launch`", "file");
  }
  if (const YamlNode* given = value_of(node, "arguments")) read_arguments(binder, *given, manifest);
  if (const YamlNode* variables = value_of(node, "environment"))
    read_variables(binder, *variables, manifest);
}

}  // namespace

std::vector<ProgramEntry> read_programs(Binder& binder, const YamlNode& node) {
  std::vector<ProgramEntry> programs;
  binder.list(node, "programs", [&](const YamlNode& item) {
    if (auto entry = read_program(binder, item)) programs.push_back(*std::move(entry));
  });
  return programs;
}

void read_launch(Binder& binder, const YamlNode& node, Manifest& manifest) {
  switch (node.kind) {
    case YamlKind::kScalar:
      if (auto file = binder.path(node, "launch")) manifest.launch_file = *std::move(file);
      return;
    case YamlKind::kMap:
      if (looks_like_nodes(node)) {
        binder.wrong_type(node, "launch", kWanted)
            .why.push_back("each node of the list begins with `- `");
      } else {
        read_file(binder, node, manifest);
      }
      return;
    case YamlKind::kNull:
      binder.wrong_type(node, "launch", kWanted);
      return;
    case YamlKind::kSequence:
      break;
  }
  if (node.items.empty())
    binder.error("R2W0103", "`launch` names no node", node.range, "expected at least one");
  for (const YamlNode& item : node.items) {
    if (auto entry = read_node(binder, item)) manifest.nodes.push_back(*std::move(entry));
  }
  warn_of_equal_names(binder, manifest.nodes);
}

}  // namespace ros2wasm
