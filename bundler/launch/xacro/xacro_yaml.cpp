// See xacro_yaml.hpp.
#include "bundler/launch/xacro/xacro_yaml.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <optional>
#include <regex>

#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/base/yaml_reader.hpp"

namespace ros2wasm {
namespace {

struct Unit {
  std::string_view tag;
  double factor;
};
constexpr std::array<Unit, 6> kUnits{{{"!radians", 1.0},
                                      {"!degrees", std::numbers::pi / 180.0},
                                      {"!meters", 1.0},
                                      {"!millimeters", 0.001},
                                      {"!foot", 0.3048},
                                      {"!inches", 0.0254}}};

template <std::size_t N>
bool is_one_of(std::string_view text, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}
constexpr std::array<std::string_view, 5> kNulls{"", "~", "null", "Null", "NULL"};
constexpr std::array<std::string_view, 9> kTrue{"yes",  "Yes", "YES", "true", "True",
                                                "TRUE", "on",  "On",  "ON"};
constexpr std::array<std::string_view, 9> kFalse{"no",    "No",  "NO",  "false", "False",
                                                 "FALSE", "off", "Off", "OFF"};

/// Longer ones are texts; no pattern sees more.
constexpr std::size_t kLongestNumber = 64;

std::optional<PythonValue> integer_of(std::string text) {
  static const std::regex pattern("[-+]?(0b[01]+|0[0-7]+|0|[1-9][0-9]*|0x[0-9a-fA-F]+)");
  if (text.size() > kLongestNumber || !std::regex_match(text, pattern)) return std::nullopt;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.erase(0, 1);
  const int base = text.starts_with("0b")                     ? 2
                   : text.starts_with("0x")                   ? 16
                   : text.size() > 1 && text.starts_with('0') ? 8
                                                              : 10;
  const std::size_t skip = base == 2 || base == 16 ? 2 : 0;
  std::int64_t number = 0;
  const auto end = text.data() + text.size();
  if (std::from_chars(text.data() + skip, end, number, base).ec != std::errc()) return std::nullopt;
  return PythonValue{negative ? -number : number};
}

std::optional<PythonValue> real_of(std::string text) {
  static const std::regex pattern(
      "[-+]?[0-9]+\\.[0-9]*([eE][-+][0-9]+)?|\\.[0-9]+([eE][-+][0-9]+)?|"
      "[-+]?\\.(inf|Inf|INF)|\\.(nan|NaN|NAN)");
  if (text.size() > kLongestNumber || !std::regex_match(text, pattern)) return std::nullopt;
  const std::size_t letters = text.find_first_of("inIN");
  if (letters != std::string::npos) text.erase(letters - 1, 1);
  return python_to_float({text});
}

PythonValue plain_value(const std::string& written) {
  if (is_one_of(written, kNulls)) return {PythonNone{}};
  if (is_one_of(written, kTrue)) return {true};
  if (is_one_of(written, kFalse)) return {false};
  std::string digits = written;
  if (!digits.starts_with('_'))
    digits.erase(std::remove(digits.begin(), digits.end(), '_'), digits.end());
  if (auto whole = integer_of(digits)) return std::move(*whole);
  if (auto real = real_of(digits)) return std::move(*real);
  return {written};
}

class Builder {
 public:
  explicit Builder(const std::function<PythonValue(const std::string&)>& calculated)
      : calculated_(calculated) {}

  PythonValue build(const YamlNode& node) const {
    if (node.kind == YamlKind::kNull) return {PythonNone{}};
    if (node.kind == YamlKind::kScalar) return scalar(node);
    if (node.kind == YamlKind::kMap) {
      PythonDict dict{.dotted = true};
      fill(node, dict);
      return python_dict(std::move(dict));
    }
    PythonList list;
    for (const YamlNode& item : node.items) list.push_back(build(item));
    return {std::move(list)};
  }

 private:
  /// Keys of `<<` come in where the map has none of its own.
  void fill(const YamlNode& map, PythonDict& dict) const {
    for (const YamlEntry& entry : map.entries)
      if (entry.key != "<<") dict.entries.emplace_back(plain_value(entry.key), build(entry.value));
    for (const YamlEntry& entry : map.entries) {
      if (entry.key != "<<") continue;
      if (entry.value.kind == YamlKind::kMap) merge(entry.value, dict);
      for (const YamlNode& item : entry.value.items)
        if (item.kind == YamlKind::kMap) merge(item, dict);
    }
  }
  void merge(const YamlNode& map, PythonDict& dict) const {
    PythonDict more;
    fill(map, more);
    for (auto& [key, value] : more.entries)
      if (python_entry(dict, key) == nullptr) dict.entries.emplace_back(key, std::move(value));
  }

  PythonValue scalar(const YamlNode& node) const {
    if (node.tag.empty() || node.tag == "?" || node.tag == "!")
      return node.quoted ? PythonValue{node.text} : plain_value(node.text);
    if (node.tag.ends_with(":str")) return {node.text};
    if (node.tag.ends_with(":int")) return python_to_integer({node.text});
    if (node.tag.ends_with(":float")) return python_to_float({node.text});
    if (node.tag.ends_with(":bool") || node.tag.ends_with(":null")) return plain_value(node.text);
    const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                   [&](const Unit& one) { return one.tag == node.tag; });
    if (unit == kUnits.end())
      throw PythonFault{"YAML has no tag `" + node.tag + "` that xacro knows"};
    const PythonValue value = python_to_float(calculated_(node.text));
    return {std::get<double>(value.held) * unit->factor};
  }

  const std::function<PythonValue(const std::string&)>& calculated_;
};

}  // namespace

Outcome<PythonValue> read_xacro_yaml(
    std::string_view text, const std::string& shown,
    const std::function<PythonValue(const std::string& expression)>& calculated) {
  const SourceText source(text, shown);
  const auto document = parse_yaml(source, DuplicateKeys::kLastCounts);
  if (!document) return document.errors();
  return Builder(calculated).build(document->root);
}

PythonValue python_dotted(const PythonValue& value) {
  if (const auto* list = std::get_if<PythonList>(&value.held)) {
    PythonList result;
    for (const PythonValue& one : *list) result.push_back(python_dotted(one));
    return {std::move(result)};
  }
  const auto* dict = std::get_if<std::shared_ptr<const PythonDict>>(&value.held);
  if (dict == nullptr) return value;
  PythonDict result{.dotted = true};
  for (const auto& [key, one] : (*dict)->entries)
    result.entries.emplace_back(key, python_dotted(one));
  return python_dict(std::move(result));
}

}  // namespace ros2wasm
