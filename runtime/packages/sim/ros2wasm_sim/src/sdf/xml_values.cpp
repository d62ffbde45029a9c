// See xml_values.hpp.
#include "sdf/xml_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace ros2wasm_sim {
namespace {

constexpr std::string_view kSpace = " \t\r\n\f\v";
constexpr double kMaxFinite = 1e15;
/// Names of nested models and lumped links are put together, so a long one would be repeated often.
constexpr std::size_t kMaxNameLength = 500;

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& letter : result) {
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return result;
}

/// Shown in a message, so not a megabyte.
std::string shown(std::string_view text) {
  return "`" + std::string(text.substr(0, 60)) + (text.size() > 60 ? "..." : "") + "`";
}

std::string tag(const Node& node) {
  return "<" + node.element->name + ">";
}

Quaternion normalized(const Quaternion& q) {
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / size, q.x / size, q.y / size, q.z / size};
}

}  // namespace

Node child(const Node& of, const std::string& name) {
  return of ? Node{of.source, of.source->document->child(*of.element, name)} : Node{};
}

Node descend(Node of, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    of = child(of, name);
  }
  return of;
}

std::vector<Node> children(const Node& of, const std::string& name) {
  std::vector<Node> result;
  if (of) {
    for (const ros2wasm_xml::XmlElement* one : of.source->document->children(*of.element, name)) {
      result.push_back({of.source, one});
    }
  }
  return result;
}

std::string trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(kSpace);
  if (from == std::string_view::npos) {
    return "";
  }
  return std::string(text.substr(from, text.find_last_not_of(kSpace) - from + 1));
}

std::string text_of(const Node& node) {
  return node ? trimmed(node.element->text) : "";
}
std::string text_of(const Node& parent, const std::string& name) {
  return text_of(child(parent, name));
}

std::string attribute(const Node& node, const std::string& name) {
  const std::string* value = node ? node.element->attribute(name) : nullptr;
  return value == nullptr ? "" : *value;
}
bool has_attribute(const Node& node, const std::string& name) {
  return node && node.element->attribute(name) != nullptr;
}

XmlView view_of(const Node& node) {
  return {node.source->document, node.element};
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> result;
  std::size_t from = text.find_first_not_of(kSpace);
  while (from != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kSpace, from), text.size());
    result.push_back(text.substr(from, end - from));
    from = text.find_first_not_of(kSpace, end);
  }
  return result;
}

std::optional<double> parse_number(std::string_view text) {
  const std::string word = lower(trimmed(text));
  const std::size_t sign = word.substr(0, 1) == "-" || word.substr(0, 1) == "+" ? 1 : 0;
  const std::string rest = word.substr(sign);
  if (rest == "inf" || rest == "infinity") {
    return word[0] == '-' ? -kInfinity : kInfinity;
  }
  if (rest == "nan") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // strtod alone would take hexadecimal numbers, and words that begin as a number does.
  if (word.size() > 400 || word.find_first_of("0123456789") == std::string::npos ||
      word.find_first_not_of("0123456789+-.e") != std::string::npos) {
    return std::nullopt;
  }
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size() ? std::optional(value) : std::nullopt;
}

std::optional<int> parse_minor_version(std::string_view version) {
  const std::size_t dot = version.find('.');
  const auto minor =
      dot == std::string_view::npos ? std::nullopt : parse_number(version.substr(dot + 1));
  return minor && *minor >= 0 && *minor < 1000 ? std::optional(static_cast<int>(*minor))
                                               : std::nullopt;
}

std::optional<double> checked_number(Context& context, const Node& where, const std::string& text,
                                     const std::string& what, Range range) {
  const std::optional<double> value = parse_number(text);
  if (!value) {
    context.error(where, what + " is not a number: " + shown(text));
    return std::nullopt;
  }
  if (std::isnan(*value) || (range != Range::kAny && !(std::fabs(*value) <= kMaxFinite))) {
    context.error(where, what + " must be a finite number of at most 1e15: " + shown(text));
    return std::nullopt;
  }
  if ((range == Range::kNotNegative && *value < 0) || (range == Range::kPositive && *value <= 0)) {
    const std::string limit = range == Range::kPositive ? "greater than 0" : "0 or greater";
    context.error(where, what + " must be " + limit + ": " + shown(text));
    return std::nullopt;
  }
  return value;
}

double number(Context& context, const Node& parent, const std::string& name, double value,
              Range range) {
  const Node node = child(parent, name);
  const std::string text = text_of(node);
  return text.empty() ? value
                      : checked_number(context, node, text, tag(node), range).value_or(value);
}

bool boolean(Context& context, const Node& parent, const std::string& name, bool value) {
  const Node node = child(parent, name);
  const std::string text = lower(text_of(node));
  if (text.empty()) {
    return value;
  }
  const bool is_true = text == "true" || text == "1" || text == "yes";
  if (!is_true && text != "false" && text != "0" && text != "no") {
    context.warning(
        node, tag(node) + " is neither true nor false, so it counts as false: " + shown(text));
  }
  return is_true;
}

std::optional<std::vector<double>> numbers(Context& context, const Node& where,
                                           std::string_view text, std::size_t count,
                                           const std::string& what, Range range) {
  const std::vector<std::string_view> words = words_of(text);
  if (words.size() != count) {
    context.error(where, what + " must have " + std::to_string(count) + " numbers, not " +
                             std::to_string(words.size()));
    return std::nullopt;
  }
  std::vector<double> result;
  for (const std::string_view word : words) {
    const auto value = checked_number(context, where, std::string(word), what, range);
    if (!value) {
      return std::nullopt;
    }
    result.push_back(*value);
  }
  return result;
}

Vector3 vector3(Context& context, const Node& parent, const std::string& name, const Vector3& value,
                Range range) {
  const Node node = child(parent, name);
  const std::string text = text_of(node);
  if (text.empty()) {
    return value;
  }
  const auto read = numbers(context, node, text, 3, tag(node), range);
  return read ? Vector3{(*read)[0], (*read)[1], (*read)[2]} : value;
}

Color color(Context& context, const Node& parent, const std::string& name, const Color& value) {
  const Node node = child(parent, name);
  const std::string text = text_of(node);
  if (text.empty()) {
    return value;
  }
  const std::size_t count = words_of(text).size() == 3 ? 3 : 4;
  const auto read = numbers(context, node, text, count, tag(node), Range::kFinite);
  if (!read) {
    return value;
  }
  const auto at = [&read](std::size_t i) { return std::clamp((*read)[i], 0.0, 1.0); };
  return {at(0), at(1), at(2), count == 4 ? at(3) : 1.0};
}

RawPose raw_pose(Context& context, const Node& parent) {
  RawPose result;
  result.where = child(parent, "pose");
  const Node& node = result.where;
  if (!node) {
    return result;
  }
  result.relative_to = trimmed(attribute(node, "relative_to"));
  const std::string text = text_of(node);
  const bool is_quaternion = attribute(node, "rotation_format") == "quat_xyzw";
  if (text.empty()) {
    return result;
  }
  std::string_view part = text;
  const std::size_t count = is_quaternion ? 7 : 6;
  const std::vector<std::string_view> words = words_of(part);
  if (words.size() == 3) {
    context.warning(node, "<pose> has 3 numbers instead of " + std::to_string(count) +
                              ", so its rotation counts as zero");
    const auto read = numbers(context, node, part, 3, "<pose>", Range::kFinite);
    if (read) {
      result.pose.position = {(*read)[0], (*read)[1], (*read)[2]};
    }
    return result;
  }
  const auto read = numbers(context, node, part, count, "<pose>", Range::kFinite);
  if (!read) {
    return result;
  }
  const std::vector<double>& n = *read;
  if (is_quaternion) {
    const Quaternion q{n[6], n[3], n[4], n[5]};
    if (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z < 1e-12) {
      context.error(node, "the quaternion of <pose> has a length of zero");
      return result;
    }
    result.pose.orientation = normalized(q);
  } else {
    const std::string degrees = lower(attribute(node, "degrees"));
    const double unit = degrees == "true" || degrees == "1" ? std::numbers::pi / 180 : 1;
    result.pose.orientation = from_roll_pitch_yaw(n[3] * unit, n[4] * unit, n[5] * unit);
  }
  result.pose.position = {n[0], n[1], n[2]};
  return result;
}

std::string checked_name(Context& context, const Node& where, const std::string& name) {
  if (name.size() > kMaxNameLength) {
    context.error(where, "the name " + shown(name) + " has more than " +
                             std::to_string(kMaxNameLength) + " bytes");
    return "";
  }
  return name;
}

std::string required_name(Context& context, const Node& node) {
  const std::string name = attribute(node, "name");
  if (name.empty()) {
    context.error(node, tag(node) + " needs the attribute `name`");
  }
  return checked_name(context, node, name);
}

}  // namespace ros2wasm_sim
