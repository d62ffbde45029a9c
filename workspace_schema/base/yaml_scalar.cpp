// See yaml_scalar.hpp.
#include "workspace_schema/base/yaml_scalar.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kTagPrefix = "tag:yaml.org,2002:";

template <std::size_t N>
bool is_one_of(std::string_view text, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

constexpr std::array<std::string_view, 5> kNulls{"", "~", "null", "Null", "NULL"};
constexpr std::array<std::string_view, 3> kTrue{"true", "True", "TRUE"};
constexpr std::array<std::string_view, 3> kFalse{"false", "False", "FALSE"};
constexpr std::array<std::string_view, 9> kInfinity{".inf",  ".Inf",  ".INF",  "+.inf", "+.Inf",
                                                    "+.INF", "-.inf", "-.Inf", "-.INF"};
constexpr std::array<std::string_view, 3> kNotANumber{".nan", ".NaN", ".NAN"};
constexpr std::array<std::string_view, 20> kOldBooleans{
    "y",  "Y",  "yes", "Yes", "YES", "n",   "N", "no", "No", "NO",
    "on", "On", "ON",  "off", "Off", "OFF", "t", "T",  "f",  "F"};

bool all_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string_view without_sign(std::string_view text) {
  return !text.empty() && (text.front() == '+' || text.front() == '-') ? text.substr(1) : text;
}

bool is_integer(std::string_view text) {
  if (text.starts_with("0x")) {
    return text.size() > 2 &&
           text.find_first_not_of("0123456789abcdefABCDEF", 2) == std::string_view::npos;
  }
  if (text.starts_with("0o")) {
    return text.size() > 2 && text.find_first_not_of("01234567", 2) == std::string_view::npos;
  }
  return all_digits(without_sign(text));
}

/// [-+]? ( . digits | digits ( . digits* )? ) ( [eE] [-+]? digits )?
bool is_float(std::string_view text) {
  text = without_sign(text);
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t begin = i;
    while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
    return i - begin;
  };
  const std::size_t before = digits();
  std::size_t behind = 0;
  if (i < text.size() && text[i] == '.') {
    ++i;
    behind = digits();
  }
  if (before + behind == 0) return false;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (digits() == 0) return false;
  }
  return i == text.size();
}

YamlValue integer_value(std::string_view text) {
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0o")) {
    base = text[1] == 'x' ? 16 : 8;
    text.remove_prefix(2);
  } else if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error != std::errc() || end != text.data() + text.size()) return YamlIntegerTooLarge{};
  return number;
}

double float_value(std::string_view text) {
  if (is_one_of(text, kNotANumber)) return std::numeric_limits<double>::quiet_NaN();
  const bool negative = text.starts_with('-');
  const double infinity = std::numeric_limits<double>::infinity();
  if (is_one_of(text, kInfinity)) return negative ? -infinity : infinity;
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto error = std::from_chars(text.data(), text.data() + text.size(), number).ec;
  if (error == std::errc::result_out_of_range) {
    const bool tiny =
        text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
    number = tiny ? 0.0 : infinity;
    if (negative) number = -number;
  }
  return number;
}

bool is_any_float(std::string_view text) {
  return is_float(text) || is_one_of(text, kInfinity) || is_one_of(text, kNotANumber);
}

YamlValue plain_value(std::string_view text) {
  if (is_one_of(text, kNulls)) return std::monostate{};
  if (is_one_of(text, kTrue)) return true;
  if (is_one_of(text, kFalse)) return false;
  if (is_integer(text)) return integer_value(text);
  if (is_any_float(text)) return float_value(text);
  return std::string(text);
}

YamlValue tagged_value(std::string_view tag, const std::string& text) {
  if (!tag.starts_with(kTagPrefix)) return YamlUnknownTag{};
  tag.remove_prefix(kTagPrefix.size());
  if (tag == "str") return text;
  if (tag == "int" && is_integer(text)) return integer_value(text);
  if (tag == "float" && (is_integer(text) || is_any_float(text))) return float_value(text);
  if (tag == "bool" && is_one_of(text, kTrue)) return true;
  if (tag == "bool" && is_one_of(text, kFalse)) return false;
  if (tag == "null" && is_one_of(text, kNulls)) return std::monostate{};
  return YamlUnknownTag{};
}

}  // namespace

YamlValue scalar_value(const YamlNode& node) {
  if (node.kind == YamlKind::kNull) return std::monostate{};
  if (!node.tag.empty()) return tagged_value(node.tag, node.text);
  if (node.quoted) return node.text;
  return plain_value(node.text);
}

std::string_view described(const YamlNode& node) {
  switch (node.kind) {
    case YamlKind::kNull:
      return "nothing";
    case YamlKind::kSequence:
      return "a list";
    case YamlKind::kMap:
      return "a mapping";
    case YamlKind::kScalar:
      break;
  }
  const YamlValue value = scalar_value(node);
  if (std::holds_alternative<std::monostate>(value)) return "nothing";
  if (std::holds_alternative<bool>(value)) return "a boolean";
  if (std::holds_alternative<std::string>(value)) return "a text";
  if (std::holds_alternative<YamlUnknownTag>(value)) return "a value with a tag";
  return "a number";
}

bool is_old_boolean(const YamlNode& node) {
  return node.kind == YamlKind::kScalar && !node.quoted && node.tag.empty() &&
         is_one_of(node.text, kOldBooleans);
}

std::string as_yaml_text(std::string_view text) {
  const bool plain_type = std::holds_alternative<std::string>(plain_value(text));
  constexpr std::string_view kNeverInside = ":#{}[],\n\t\\\"";
  constexpr std::string_view kNeverFirst = "-?&*!|>'%@` ";
  const bool plain_shape =
      !text.empty() && text.find_first_of(kNeverInside) == std::string_view::npos &&
      kNeverFirst.find(text.front()) == std::string_view::npos && text.back() != ' ' &&
      std::all_of(text.begin(), text.end(),
                  [](char c) { return static_cast<unsigned char>(c) >= 0x20; });
  return plain_type && plain_shape && !is_one_of(text, kOldBooleans) ? std::string(text)
                                                                     : json_quoted(text);
}

}  // namespace ros2wasm
