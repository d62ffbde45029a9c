// Elements of SDF and URDF as numbers, vectors, poses and colours. A mistake becomes a note, and
// the default stays.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sdf/context.hpp"

namespace ros2wasm_sim {

/// The first child with a name, or nothing.
Node child(const Node& of, const std::string& name);
/// The child of a child: `descend(node, {"surface", "friction", "ode"})`.
Node descend(Node of, std::initializer_list<const char*> names);
/// The children with a name, or all of them.
std::vector<Node> children(const Node& of, const std::string& name = "");
/// The text without the space around it; empty for no element.
std::string text_of(const Node& node);
std::string text_of(const Node& parent, const std::string& name);
/// The value, or nothing.
std::string attribute(const Node& node, const std::string& name);
bool has_attribute(const Node& node, const std::string& name);
XmlView view_of(const Node& node);

/// Words between spaces.
std::vector<std::string_view> words_of(std::string_view text);
std::string trimmed(std::string_view text);
/// A decimal number, `inf` or `nan`; nothing for other text.
std::optional<double> parse_number(std::string_view text);

/// 10 of `1.10`, or nothing.
std::optional<int> parse_minor_version(std::string_view version);
constexpr int kNewestMinorVersion = 12;

enum class Range {
  kAny,          ///< infinity too
  kFinite,       ///< at most 1e15
  kNotNegative,  ///< and finite
  kPositive,     ///< and finite
};
/// A number from a text that `what` names in messages.
std::optional<double> checked_number(Context& context, const Node& where, const std::string& text,
                                     const std::string& what, Range range);

/// The value of the child with a name; the default when there is none, or it is empty or wrong.
double number(Context& context, const Node& parent, const std::string& name, double value,
              Range range = Range::kFinite);
bool boolean(Context& context, const Node& parent, const std::string& name, bool value);
Vector3 vector3(Context& context, const Node& parent, const std::string& name, const Vector3& value,
                Range range = Range::kFinite);
/// A colour of three or four values from 0 to 1.
Color color(Context& context, const Node& parent, const std::string& name, const Color& value);
/// `count` numbers of a text, or nothing with an error.
std::optional<std::vector<double>> numbers(Context& context, const Node& where,
                                           std::string_view text, std::size_t count,
                                           const std::string& what, Range range);

/// A pose as written: where it is depends on the frame.
struct RawPose {
  Pose pose;
  std::string relative_to;  ///< empty: that of the element by default
  Node where;               ///< the <pose>; nothing when there is none
};
RawPose raw_pose(Context& context, const Node& parent);

/// The name, or empty with an error when it is too long.
std::string checked_name(Context& context, const Node& where, const std::string& name);
/// The attribute `name` of an element that must have one; empty with an error when it is
/// missing or too long.
std::string required_name(Context& context, const Node& node);

}  // namespace ros2wasm_sim
