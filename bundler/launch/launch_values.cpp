// See launch_values.hpp.
#include "bundler/launch/launch_values.hpp"

#include <charconv>

#include "bundler/launch/node_arguments.hpp"
#include "bundler/launch/parameter_file.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/base/trimmed_text.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kListOf = "list_of_";

Diagnostic fault(std::string message, const SourceSpan& span, std::string why = {}) {
  Diagnostic result{.code = "R2W0410", .message = std::move(message), .span = span};
  if (!why.empty()) result.why.push_back(std::move(why));
  return result;
}

template <typename T>
std::optional<T> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  T result{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return result;
}

std::optional<ParameterValue> as_type(const std::string& text, std::string_view type) {
  if (type == "str") return ParameterValue(text);
  const std::string plain(trimmed(text));
  if (type == "bool") {
    if (const auto value = launch_boolean(plain)) return ParameterValue(*value);
  } else if (type == "int") {
    if (const auto value = number<std::int64_t>(plain)) return ParameterValue(*value);
  } else if (type == "float") {
    if (const auto value = number<double>(plain)) return ParameterValue(*value);
  }
  return std::nullopt;
}

std::vector<std::string> items_of(const std::string& text, const std::string& separator) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  for (std::size_t at = text.find(separator); at != std::string::npos;
       at = text.find(separator, begin)) {
    result.emplace_back(trimmed(std::string_view(text).substr(begin, at - begin)));
    begin = at + separator.size();
  }
  result.emplace_back(trimmed(std::string_view(text).substr(begin)));
  return result;
}

/// `y`, `n`, `t` and `f` are texts in launch files, though booleans in parameter files.
void keep_letters(YamlNode& node) {
  if (is_old_boolean(node) && node.text.size() == 1) node.quoted = true;
  for (YamlNode& item : node.items) keep_letters(item);
}

Outcome<ParameterValue> as_yaml(const std::string& text, const SourceSpan& span) {
  if (text.empty()) return ParameterValue(text);
  const SourceText source(text, span.file);
  auto read = parse_yaml(source);
  if (read) keep_letters(read->root);
  const auto value = read && read->problems.empty() ? parameter_value(read->root) : std::nullopt;
  if (value) return *value;
  return fault("`" + text.substr(0, 60) + "` is not a value that a parameter can have", span,
               "it is read as YAML: a text with marks of YAML in it needs `type=\"str\"`");
}

template <typename T>
bool all_are(const std::vector<ParameterValue>& items) {
  for (const ParameterValue& item : items)
    if (!std::holds_alternative<T>(item)) return false;
  return true;
}

template <typename T>
ParameterValue list_of(const std::vector<ParameterValue>& items) {
  std::vector<T> result;
  for (const ParameterValue& item : items) result.push_back(std::get<T>(item));
  return result;
}

}  // namespace

std::optional<std::string> launch_value_text(const LaunchAttributeValue& value) {
  if (const bool* one = std::get_if<bool>(&value)) return *one ? "true" : "false";
  if (const auto* one = std::get_if<std::int64_t>(&value)) return std::to_string(*one);
  if (const auto* one = std::get_if<double>(&value)) return parameter_text(*one);
  if (const auto* one = std::get_if<std::string>(&value)) return *one;
  return std::nullopt;
}

std::optional<bool> launch_boolean(std::string_view text) {
  const std::string word = ascii_lower(text);
  if (word == "true" || word == "1" || word == "on" || word == "yes") return true;
  if (word == "false" || word == "0" || word == "off" || word == "no") return false;
  return std::nullopt;
}

std::optional<ParameterValue> list_parameter(const std::vector<ParameterValue>& items) {
  if (all_are<std::string>(items)) return list_of<std::string>(items);  // and an empty one
  if (all_are<std::int64_t>(items)) return list_of<std::int64_t>(items);
  if (all_are<double>(items)) return list_of<double>(items);
  if (all_are<bool>(items)) return list_of<bool>(items);
  std::vector<ParameterValue> real;
  for (const ParameterValue& item : items) {
    const auto* whole = std::get_if<std::int64_t>(&item);
    real.push_back(whole != nullptr ? ParameterValue(static_cast<double>(*whole)) : item);
  }
  if (all_are<double>(real)) return list_of<double>(real);
  return std::nullopt;
}

Outcome<ParameterValue> typed_parameter(const std::string& text, const std::string& type,
                                        const std::string& separator, const SourceSpan& span) {
  const bool list = type.starts_with(kListOf) || !separator.empty();
  if (!list) {
    if (type.empty()) return as_yaml(text, span);
    if (auto value = as_type(text, type)) return *value;
    return fault("`" + text.substr(0, 60) + "` is not of type " + type, span,
                 "types are bool, int, float, str and list_of_bool to list_of_str");
  }
  if (separator.empty()) return as_yaml(text, span);
  const std::string item_type =
      type.starts_with(kListOf) ? type.substr(kListOf.size()) : std::string();
  std::vector<ParameterValue> items;
  for (const std::string& item : items_of(text, separator)) {
    auto value = typed_parameter(item, item_type, "", span);
    if (!value) return value;
    items.push_back(std::move(*value));
  }
  if (auto value = list_parameter(items)) return *value;
  return fault("the items of `" + text.substr(0, 60) + "` differ in type", span);
}

}  // namespace ros2wasm
