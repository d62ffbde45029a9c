// See urdf_robot.hpp.
#include "sdf/urdf_robot.hpp"

#include <algorithm>

#include "sdf/sdf_joint.hpp"
#include "sdf/urdf_shapes.hpp"

namespace ros2wasm_sim {
namespace {

UrdfLink read_urdf_link(Context& context, const Node& node, const UrdfMaterials& materials) {
  UrdfLink result;
  result.where = node;
  result.link.name = attribute(node, "name");
  result.inertial = urdf_inertial(context, node);
  for (const Node& one : children(node)) {
    const bool is_collision = one.element->name == "collision";
    if ((!is_collision && one.element->name != "visual") || !context.spend(one)) {
      continue;
    }
    if (is_collision) {
      result.link.collisions.push_back(urdf_collision(context, one));
    } else {
      result.link.visuals.push_back(urdf_visual(context, one, materials));
    }
  }
  return result;
}

void read_limits(Context& context, UrdfJoint& joint) {
  const Node limit = child(joint.where, "limit");
  const bool is_continuous = joint.type == "continuous";
  if (!limit) {
    if (!is_continuous) {
      context.error(joint.where,
                    "the " + joint.type + " joint `" + joint.name + "` needs a <limit>");
    }
    return;
  }
  if (!is_continuous) {
    joint.axis.lower = urdf_number(context, limit, "lower", 0, Range::kAny);
    joint.axis.upper = urdf_number(context, limit, "upper", 0, Range::kAny);
  }
  joint.axis.effort = urdf_number(context, limit, "effort", std::nullopt, Range::kAny);
  joint.axis.velocity = urdf_number(context, limit, "velocity", std::nullopt, Range::kAny);
  tidy_limits(context, limit, joint.name, joint.axis);
}

void read_urdf_axis(Context& context, UrdfJoint& joint) {
  joint.axis.xyz = {1, 0, 0};
  const Node axis = child(joint.where, "axis");
  if (axis && has_attribute(axis, "xyz")) {
    const std::string text = attribute(axis, "xyz");
    const auto read = numbers(context, axis, text, 3, "`xyz`", Range::kFinite);
    const Vector3 xyz = read ? Vector3{(*read)[0], (*read)[1], (*read)[2]} : joint.axis.xyz;
    if (length(xyz) < 1e-9) {
      context.error(axis, "the axis of the joint `" + joint.name + "` has a length of zero");
    } else {
      joint.axis.xyz = (1 / length(xyz)) * xyz;
    }
  }
  read_limits(context, joint);
  if (const Node dynamics = child(joint.where, "dynamics")) {
    joint.axis.damping = urdf_number(context, dynamics, "damping", 0);
    joint.axis.friction = urdf_number(context, dynamics, "friction", 0);
  }
  if (const Node mimic = child(joint.where, "mimic")) {
    Mimic value;
    value.joint = attribute(mimic, "joint");
    value.multiplier = urdf_number(context, mimic, "multiplier", 1);
    value.offset = urdf_number(context, mimic, "offset", 0);
    joint.axis.mimic = value;
  }
}

std::size_t link_named(Context& context, const UrdfRobot& robot, const UrdfJoint& joint,
                       const char* role) {
  const Node node = child(joint.where, role);
  const std::string name = attribute(node, "link");
  const auto found = robot.link_index.find(name);
  if (!name.empty() && found != robot.link_index.end()) {
    return found->second;
  }
  if (name.empty()) {
    context.error(joint.where,
                  "the joint `" + joint.name + "` needs a <" + role + " link=\"...\"/>");
    return kNone;
  }
  const auto names = [&robot] {
    std::vector<std::string> result;
    for (const UrdfLink& link : robot.links) {
      result.push_back(link.link.name);
    }
    return result;
  };
  context.error(node, "the " + std::string(role) + " `" + name + "` of the joint `" + joint.name +
                          "` does not exist" + context.hint(name, names));
  return kNone;
}

UrdfJoint read_urdf_joint(Context& context, const Node& node, const UrdfRobot& robot) {
  UrdfJoint joint;
  joint.where = node;
  joint.name = attribute(node, "name");
  joint.type = attribute(node, "type");
  const bool has_axis =
      joint.type == "revolute" || joint.type == "continuous" || joint.type == "prismatic";
  if (!has_axis && joint.type != "fixed" && joint.type != "floating" && joint.type != "planar") {
    context.error(node, "the joint `" + joint.name + "` is of type `" + joint.type +
                            "`, which does not exist: types are fixed, revolute, continuous, "
                            "prismatic, floating and planar");
  }
  joint.parent = link_named(context, robot, joint, "parent");
  joint.child = link_named(context, robot, joint, "child");
  joint.origin = urdf_origin(context, node);
  if (has_axis) {
    read_urdf_axis(context, joint);
  }
  return joint;
}

void read_joints(Context& context, const Node& node, UrdfRobot& robot) {
  for (const Node& one : children(node, "joint")) {
    if (!context.spend(one) || required_name(context, one).empty()) {
      continue;
    }
    UrdfJoint joint = read_urdf_joint(context, one, robot);
    if (!robot.joint_index.emplace(joint.name, robot.joints.size()).second) {
      context.error(one, "the robot has two joints `" + joint.name + "`");
      continue;
    }
    if (joint.child != kNone && joint.parent != kNone) {
      UrdfLink& link = robot.links[joint.child];
      if (link.joint != kNone) {
        context.error(one, "the link `" + link.link.name + "` is the child of two joints, `" +
                               robot.joints[link.joint].name + "` and `" + joint.name + "`");
      } else {
        link.joint = robot.joints.size();
        robot.links[joint.parent].below.push_back(robot.joints.size());
      }
    }
    robot.joints.push_back(std::move(joint));
  }
}

/// Puts all links in order from the root, with their places. False when some are not reached.
bool order_links(UrdfRobot& robot) {
  for (UrdfLink& link : robot.links) {
    std::sort(link.below.begin(), link.below.end(), [&robot](std::size_t a, std::size_t b) {
      return robot.joints[a].name < robot.joints[b].name;
    });
  }
  std::vector<std::size_t> open{robot.root};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    robot.order.push_back(at);
    const UrdfLink& link = robot.links[at];
    for (auto below = link.below.rbegin(); below != link.below.rend(); ++below) {
      const UrdfJoint& joint = robot.joints[*below];
      robot.links[joint.child].in_root = link.in_root * joint.origin;
      open.push_back(joint.child);
    }
  }
  return robot.order.size() == robot.links.size();
}

bool find_root(Context& context, const Node& node, UrdfRobot& robot) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].joint != kNone) {
      continue;
    }
    if (robot.root != kNone) {
      context.error(robot.links[i].where,
                    "the links `" + robot.links[robot.root].link.name + "` and `" +
                        robot.links[i].link.name +
                        "` both have no parent joint: a robot has one root link");
      return false;
    }
    robot.root = i;
  }
  if (robot.root == kNone) {
    context.error(node, robot.links.empty() ? "the robot has no link"
                                            : "the robot has no root: each link is the child of a "
                                              "joint, so the joints form a loop");
    return false;
  }
  return true;
}

}  // namespace

std::optional<UrdfRobot> read_robot(Context& context, const Node& node) {
  UrdfRobot robot;
  robot.name = attribute(node, "name");
  if (robot.name.empty()) {
    context.error(node, "<robot> needs the attribute `name`");
  }
  robot.pose = urdf_origin(context, node);
  const UrdfMaterials materials = urdf_materials(context, node);
  for (const Node& one : children(node, "link")) {
    if (!context.spend(one) || required_name(context, one).empty()) {
      continue;
    }
    UrdfLink link = read_urdf_link(context, one, materials);
    if (!robot.link_index.emplace(link.link.name, robot.links.size()).second) {
      context.error(one, "the robot has two links `" + link.link.name + "`");
      continue;
    }
    robot.links.push_back(std::move(link));
  }
  read_joints(context, node, robot);
  // A joint without its link would make each link below another root.
  if (context.has_error() || !find_root(context, node, robot)) {
    return std::nullopt;
  }
  if (!order_links(robot)) {
    context.error(node, "some joints form a loop, so their links are not connected to the root `" +
                            robot.links[robot.root].link.name + "`");
    return std::nullopt;
  }
  return robot;
}

}  // namespace ros2wasm_sim
