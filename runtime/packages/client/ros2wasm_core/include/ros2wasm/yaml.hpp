// The YAML of parameter files and of `-p name:=value`: maps, lists, scalars, comments, quotes.
// Anchors, aliases, tags but !!str, and block scalars are refused with their line.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ros2wasm {

struct YamlNode {
  enum class Kind { scalar, sequence, map };
  Kind kind = Kind::scalar;
  std::string text;
  /// Quoted, or tagged !!str: text whatever it looks like.
  bool is_text = false;
  std::vector<YamlNode> items;
  std::vector<std::pair<std::string, YamlNode>> entries;
};

/// Throws std::runtime_error with "line N: ..." for what it cannot read.
YamlNode parse_yaml(std::string_view text);

using ParameterScalar = std::variant<std::monostate, bool, int64_t, double, std::string>;
using ParameterData =
    std::variant<std::monostate, bool, int64_t, double, std::string, std::vector<bool>,
                 std::vector<int64_t>, std::vector<double>, std::vector<std::string>>;

/// A scalar or a list of one type, by the rules of ROS parameters (integers among doubles become
/// doubles). Throws std::runtime_error for anything else.
ParameterData to_parameter(const YamlNode& node);

}  // namespace ros2wasm
