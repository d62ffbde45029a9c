// See sdf_joint.hpp.
#include "sdf/sdf_joint.hpp"

#include <map>
#include <numbers>
#include <unordered_set>

#include "sdf/sdf_link.hpp"

namespace ros2wasm_sim {
namespace {

/// Old files write this for a limit that is not there.
constexpr double kNoLimit = 1e16;

std::optional<JointType> type_of(const std::string& text) {
  static const std::map<std::string, JointType> kTypes = {
      {"fixed", JointType::kFixed},         {"revolute", JointType::kRevolute},
      {"continuous", JointType::kRevolute}, {"prismatic", JointType::kPrismatic},
      {"ball", JointType::kBall},           {"universal", JointType::kUniversal},
      {"revolute2", JointType::kRevolute2}, {"screw", JointType::kScrew}};
  const auto found = kTypes.find(text);
  return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

std::size_t count_of_axes(JointType type) {
  switch (type) {
    case JointType::kFixed:
    case JointType::kBall:
      return 0;
    case JointType::kRevolute:
    case JointType::kPrismatic:
    case JointType::kScrew:
      return 1;
    case JointType::kUniversal:
    case JointType::kRevolute2:
      return 2;
  }
  return 0;
}

Vector3 read_direction(Context& context, const Node& axis, const Scope& scope, const Pose& joint) {
  Vector3 xyz = vector3(context, axis, "xyz", {0, 0, 1});
  const double size = length(xyz);
  const Node node = child(axis, "xyz");
  if (size < 1e-9) {
    context.error(node, "<xyz> of a joint's axis has a length of zero");
    return {0, 0, 1};
  }
  xyz = (1 / size) * xyz;
  const std::string frame = attribute(node, "expressed_in");
  // Up to version 1.4 axes were in the frame of the model.
  const bool in_model =
      boolean(context, axis, "use_parent_model_frame", axis.source->minor_version < 5);
  if (frame.empty() && !in_model) {
    return xyz;
  }
  const Pose expressed_in = scope.place(context, frame, node).pose;
  return rotate(inverse(joint.orientation) * expressed_in.orientation, xyz);
}

std::optional<Mimic> read_mimic(Context& context, const Node& axis) {
  const Node node = child(axis, "mimic");
  if (!node) {
    return std::nullopt;
  }
  Mimic mimic;
  mimic.joint = attribute(node, "joint");
  if (mimic.joint.empty()) {
    context.error(node, "<mimic> needs the attribute `joint`");
    return std::nullopt;
  }
  mimic.multiplier = number(context, node, "multiplier", mimic.multiplier);
  mimic.offset = number(context, node, "offset", mimic.offset);
  mimic.reference = number(context, node, "reference", mimic.reference);
  return mimic;
}

JointAxis read_axis(Context& context, const Node& node, const Scope& scope, const Pose& pose,
                    const std::string& joint, bool has_limits) {
  JointAxis axis;
  if (!node) {
    return axis;
  }
  axis.xyz = read_direction(context, node, scope, pose);
  const Node limit = child(node, "limit");
  if (has_limits) {
    axis.lower = number(context, limit, "lower", axis.lower, Range::kAny);
    axis.upper = number(context, limit, "upper", axis.upper, Range::kAny);
  }
  axis.effort = number(context, limit, "effort", axis.effort, Range::kAny);
  axis.velocity = number(context, limit, "velocity", axis.velocity, Range::kAny);
  tidy_limits(context, limit, joint, axis);
  const Node dynamics = child(node, "dynamics");
  axis.damping = number(context, dynamics, "damping", axis.damping);
  axis.friction = number(context, dynamics, "friction", axis.friction);
  axis.spring_stiffness = number(context, dynamics, "spring_stiffness", axis.spring_stiffness);
  axis.spring_reference = number(context, dynamics, "spring_reference", axis.spring_reference);
  axis.mimic = read_mimic(context, node);
  return axis;
}

/// The link of a <parent> or <child>.
std::string link_named(Context& context, const Node& joint, const std::string& name,
                       const Scope& scope, const char* role) {
  const Node node = child(joint, role);
  const std::string what = "the joint `" + attribute(joint, "name") + "`";
  if (name.empty()) {
    context.error(joint, what + " needs a <" + role + ">");
    return "";
  }
  const std::optional<Place> place = scope.find(name);
  if (!place || place->link.empty()) {
    context.error(node, "the " + std::string(role) + " `" + name + "` of " + what +
                            " does not exist" + context.hint(name, [&] { return scope.names(); }));
    return "";
  }
  return place->link;
}

/// In metres per turn. Before SDF 1.10 it was in radians per metre, left-handed.
double read_thread_pitch(Context& context, const Node& joint) {
  const double modern = number(context, joint, "screw_thread_pitch", 1);
  const double old = number(context, joint, "thread_pitch", 0);
  return child(joint, "screw_thread_pitch") || old == 0 ? modern : -2 * std::numbers::pi / old;
}

}  // namespace

void tidy_limits(Context& context, const Node& where, const std::string& joint, JointAxis& axis) {
  axis.lower = axis.lower <= -kNoLimit ? -kInfinity : axis.lower;
  axis.upper = axis.upper >= kNoLimit ? kInfinity : axis.upper;
  axis.effort = axis.effort < 0 || axis.effort >= kNoLimit ? kInfinity : axis.effort;
  axis.velocity = axis.velocity < 0 || axis.velocity >= kNoLimit ? kInfinity : axis.velocity;
  if (axis.lower > axis.upper) {
    context.warning(where, "the joint `" + joint +
                               "` has a lower limit above its upper limit; they are swapped");
    std::swap(axis.lower, axis.upper);
  }
}

std::optional<Joint> read_joint(Context& context, const Node& node, const Scope& scope) {
  Joint joint;
  joint.name = attribute(node, "name");
  const std::string type = attribute(node, "type");
  const std::optional<JointType> known = type_of(type);
  if (!known) {
    const std::string what = "the joint `" + joint.name + "` is of type `" + type + "`";
    if (type == "gearbox") {
      context.warning(node, what + ", which is not supported, and is skipped");
    } else {
      context.error(node, what +
                              ", which does not exist: types are fixed, revolute, continuous, "
                              "prismatic, ball, universal, revolute2 and screw");
    }
    return std::nullopt;
  }
  joint.type = *known;
  const std::string parent = text_of(node, "parent");
  const std::string child_name = text_of(node, "child");
  joint.parent = parent == "world" ? "world" : link_named(context, node, parent, scope, "parent");
  joint.child = link_named(context, node, child_name, scope, "child");
  if (joint.parent.empty() || joint.child.empty()) {
    return std::nullopt;
  }
  if (joint.parent == joint.child) {
    context.error(
        node, "the joint `" + joint.name + "` connects the link `" + joint.child + "` to itself");
    return std::nullopt;
  }
  const Pose in_model = scope.find_joint(joint.name).value_or(Place{}).pose;
  joint.pose = inverse(scope.place(context, joint.child, node).pose) * in_model;
  const char* const names[] = {"axis", "axis2"};
  for (std::size_t i = 0; i < count_of_axes(joint.type); ++i) {
    joint.axes.push_back(read_axis(context, child(node, names[i]), scope, in_model, joint.name,
                                   type != "continuous"));
  }
  if (joint.type == JointType::kScrew) {
    joint.thread_pitch = read_thread_pitch(context, node);
  }
  for (const Node& sensor : children(node, "sensor")) {
    if (context.spend(sensor)) {
      joint.sensors.push_back(read_sensor(context, sensor, scope, joint.name, in_model));
    }
  }
  return joint;
}

void check_mimics(Context& context, const std::vector<Node>& nodes,
                  const std::vector<Joint>& joints) {
  std::unordered_set<std::string> names;
  for (const Joint& joint : joints) {
    names.insert(joint.name);
  }
  const auto all = [&joints] {
    std::vector<std::string> result;
    for (const Joint& one : joints) {
      result.push_back(one.name);
    }
    return result;
  };
  for (const Node& node : nodes) {
    const std::string joint = attribute(node, "name");
    for (const char* axis : {"axis", "axis2"}) {
      const Node mimic = descend(node, {axis, "mimic"});
      const std::string other = attribute(mimic, "joint");
      if (other.empty() || (names.count(other) != 0 && other != joint)) {
        continue;
      }
      context.error(mimic, "the joint `" + joint + "` mimics the joint `" + other +
                               "`, which does not exist or is itself" + context.hint(other, all));
    }
  }
}

}  // namespace ros2wasm_sim
