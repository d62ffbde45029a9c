// See launch_frontends.hpp.
#include "bundler/launch/launch_frontends.hpp"

#include <utility>

#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/xml_reader.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

Diagnostic not_a_launch_file(std::string message, SourceSpan span, std::string why = {}) {
  Diagnostic result{.code = "R2W0410", .message = std::move(message), .span = std::move(span)};
  if (!why.empty()) result.why.push_back(std::move(why));
  return result;
}

LaunchEntity entity_of(const XmlElement& element) {
  LaunchEntity entity{.tag = element.name, .span = element.span, .attributes = {}, .children = {}};
  for (const auto& [name, value] : element.attributes)
    entity.attributes.push_back({.name = name, .value = value, .span = element.span});
  for (const XmlElement& child : element.children) entity.children.push_back(entity_of(child));
  return entity;
}

/// Turns the YAML form into entities. The children of an action are those of its lists that hold
/// mappings, each under its key; `children` holds actions.
class YamlEntities {
 public:
  explicit YamlEntities(const SourceText& source) : source_(source) {}

  /// `node` is the value under `tag`.
  LaunchEntity entity(const std::string& tag, TextRange tag_range, const YamlNode& node) {
    LaunchEntity result{.tag = tag, .span = span(tag_range), .attributes = {}, .children = {}};
    switch (node.kind) {
      case YamlKind::kSequence:
        actions(node, result);
        break;
      case YamlKind::kMap:
        for (const YamlEntry& entry : node.entries) member(entry, result);
        break;
      case YamlKind::kNull:
        break;
      case YamlKind::kScalar:
        fail(node.range,
             "`" + tag + "` takes a mapping or a list, found " + std::string(described(node)));
        break;
    }
    return result;
  }

  [[nodiscard]] Diagnostics& errors() { return errors_; }

 private:
  void actions(const YamlNode& list, LaunchEntity& into) {
    for (const YamlNode& item : list.items) {
      if (item.kind == YamlKind::kMap && item.entries.size() == 1) {
        const YamlEntry& only = item.entries.front();
        into.children.push_back(entity(only.key, only.key_range, only.value));
      } else {
        fail(item.range, "an item of this list is one action, such as `- node: {...}`");
      }
    }
  }

  void member(const YamlEntry& entry, LaunchEntity& into) {
    const YamlNode& value = entry.value;
    if (entry.key == "children") {
      if (value.kind == YamlKind::kSequence) {
        actions(value, into);
      } else {
        fail(value.range, "`children` is a list of actions");
      }
    } else if (value.kind == YamlKind::kMap) {
      into.children.push_back(entity(entry.key, entry.key_range, value));
    } else if (value.kind == YamlKind::kSequence) {
      list(entry, into);
    } else if (auto one = scalar(value)) {
      add(entry, std::visit([](auto& held) { return LaunchAttributeValue(std::move(held)); }, *one),
          into);
    }
  }

  /// A list of mappings is one part of the action each; a list of values is an attribute.
  void list(const YamlEntry& entry, LaunchEntity& into) {
    std::vector<LaunchScalar> values;
    for (const YamlNode& item : entry.value.items) {
      if (item.kind == YamlKind::kMap) {
        into.children.push_back(entity(entry.key, item.range, item));
      } else if (auto one = scalar(item)) {
        values.push_back(std::move(*one));
      }
    }
    if (!values.empty() || entry.value.items.empty()) add(entry, std::move(values), into);
  }

  void add(const YamlEntry& entry, LaunchAttributeValue value, LaunchEntity& into) {
    into.attributes.push_back(
        {.name = entry.key, .value = std::move(value), .span = span(entry.value.range)});
  }

  std::optional<LaunchScalar> scalar(const YamlNode& node) {
    if (is_old_boolean(node) && node.text.size() > 1)
      return node.text.front() == 'y' || node.text.front() == 'Y' || node.text.size() == 2;
    const YamlValue value = scalar_value(node);
    if (const auto* one = std::get_if<bool>(&value)) return *one;
    if (const auto* one = std::get_if<std::int64_t>(&value)) return *one;
    if (const auto* one = std::get_if<double>(&value)) return *one;
    if (const auto* one = std::get_if<std::string>(&value)) return *one;
    if (node.kind == YamlKind::kNull) return std::string();
    fail(node.range,
         "expected a text, a number or a boolean, found " + std::string(described(node)));
    return std::nullopt;
  }

  SourceSpan span(TextRange range) const { return source_.span(range.offset, range.length); }
  void fail(TextRange range, std::string message) {
    errors_.push_back(not_a_launch_file(std::move(message), span(range)));
  }

  const SourceText& source_;
  Diagnostics errors_;
};

}  // namespace

LaunchLanguage launch_language(std::string_view file, std::string_view text) {
  if (file.ends_with(".py")) return LaunchLanguage::kPython;
  if (file.ends_with(".xml")) return LaunchLanguage::kXml;
  if (file.ends_with(".yaml") || file.ends_with(".yml")) return LaunchLanguage::kYaml;
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string_view::npos && text[first] == '<' ? LaunchLanguage::kXml
                                                               : LaunchLanguage::kYaml;
}

Outcome<LaunchEntity> read_xml_launch(std::string_view text, const std::string& file) {
  auto root = parse_xml(text, file);
  if (!root) return std::move(root).errors();
  if (root->name != "launch")
    return not_a_launch_file("a launch file's root is `<launch>`, found `<" + root->name + ">`",
                             root->span);
  return entity_of(*root);
}

Outcome<LaunchEntity> read_yaml_launch(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  auto document = parse_yaml(source);
  if (!document) return std::move(document).errors();
  const YamlNode& root = document->root;
  if (root.kind != YamlKind::kMap || root.entries.size() != 1 ||
      root.entries.front().key != "launch")
    return not_a_launch_file("a launch file in YAML has one key, `launch`",
                             source.span(root.range.offset, root.range.length),
                             "its value is a list of actions, such as `- node: {...}`");
  YamlEntities entities(source);
  LaunchEntity result =
      entities.entity("launch", root.entries.front().key_range, root.entries.front().value);
  for (Diagnostic& problem : document->problems) entities.errors().push_back(std::move(problem));
  if (!entities.errors().empty()) return std::move(entities.errors());
  return result;
}

}  // namespace ros2wasm
