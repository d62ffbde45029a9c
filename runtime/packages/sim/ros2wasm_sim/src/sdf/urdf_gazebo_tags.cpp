// See urdf_gazebo_tags.hpp.
#include "sdf/urdf_gazebo_tags.hpp"

#include <algorithm>
#include <string_view>

#include "sdf/sdf_geometry.hpp"
#include "sdf/sdf_joint.hpp"
#include "sdf/sdf_link.hpp"
#include "sdf/sdf_material.hpp"

namespace ros2wasm_sim {
namespace {

/// `<mu1>0.2</mu1>` or `<mu1 value="0.2"/>`.
std::string value_of(const Node& node) {
  const std::string value = trimmed(attribute(node, "value"));
  return value.empty() ? text_of(node) : value;
}

bool is_true(const Node& node) {
  std::string text = value_of(node);
  for (char& letter : text) {
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return text == "true" || text == "yes" || text == "1";
}

void set_number(Context& context, const Node& node, Range range,
                const std::function<void(double)>& set) {
  const std::string what = "<" + node.element->name + ">";
  if (const auto value = checked_number(context, node, value_of(node), what, range)) {
    set(*value);
  }
}

class LinkTags {
 public:
  LinkTags(Context& context, const Scope& scope, UrdfLink& link)
      : context_(context), scope_(scope), link_(link.link), in_root_(link.in_root) {}

  void apply(const Node& tag) {
    for (const Node& one : children(tag)) {
      apply_one(one);
    }
  }

 private:
  void apply_one(const Node& one);
  bool apply_surface(const Node& one);
  void apply_material(const Node& one);

  Context& context_;
  const Scope& scope_;
  Link& link_;
  Pose in_root_;
};

bool LinkTags::apply_surface(const Node& one) {
  const std::string& name = one.element->name;
  const auto each = [this](double Surface::*member) {
    return [this, member](double value) {
      for (Collision& collision : link_.collisions) {
        collision.surface.*member = value;
      }
    };
  };
  if (name == "mu1") {
    set_number(context_, one, Range::kNotNegative, each(&Surface::mu));
  } else if (name == "mu2") {
    set_number(context_, one, Range::kNotNegative, each(&Surface::mu2));
  } else if (name == "fdir1") {
    const auto read = numbers(context_, one, value_of(one), 3, "<fdir1>", Range::kFinite);
    for (Collision& collision : link_.collisions) {
      collision.surface.fdir1 = read ? Vector3{(*read)[0], (*read)[1], (*read)[2]} : Vector3{};
    }
  } else if (name == "collision") {
    for (Collision& collision : link_.collisions) {
      read_surface(context_, child(one, "surface"), collision.surface);
    }
  } else {
    return false;
  }
  return true;
}

void LinkTags::apply_material(const Node& one) {
  const std::string name = value_of(one);
  if (name.empty()) {
    return;
  }
  const Material material = named_material(context_, one, name);
  for (Visual& visual : link_.visuals) {
    visual.material = material;
  }
}

void LinkTags::apply_one(const Node& one) {
  const std::string& name = one.element->name;
  if (apply_surface(one)) {
    return;
  }
  if (name == "material") {
    apply_material(one);
  } else if (name == "visual") {
    for (Visual& visual : link_.visuals) {
      read_visual_properties(context_, one, visual);
    }
  } else if (name == "selfCollide" || name == "self_collide") {
    link_.self_collide = is_true(one);
  } else if (name == "turnGravityOff") {
    link_.gravity = !is_true(one);
  } else if (name == "gravity") {
    link_.gravity = is_true(one);
  } else if (name == "kinematic") {
    link_.kinematic = is_true(one);
  } else if (name == "sensor" && context_.spend(one)) {
    link_.sensors.push_back(read_sensor(context_, one, scope_, link_.name, in_root_));
  } else if (name == "light" && context_.spend(one)) {
    Light light = read_light(context_, one);
    const RawPose pose = raw_pose(context_, one);
    light.pose = pose.relative_to.empty()
                     ? pose.pose
                     : inverse(in_root_) * scope_.pose_in_root(context_, pose, "");
    link_.lights.push_back(std::move(light));
  } else if (name == "plugin") {
    context_.warning(one, "the plugin `" + attribute(one, "name") + "` is in <gazebo reference=\"" +
                              link_.name +
                              "\"> and is not loaded: put it into a <gazebo> without "
                              "`reference`, or into a <sensor>");
  } else if (name == "mu") {
    context_.warning(
        one, "<mu> in <gazebo reference=\"" + link_.name + "\"> has no effect: write <mu1>");
  }
}

void apply_joint_tag(Context& context, const Node& tag, const Scope& scope, const Pose& pose,
                     UrdfJoint& joint) {
  for (const Node& one : children(tag)) {
    const std::string& name = one.element->name;
    if (name == "preserveFixedJoint") {
      joint.is_preserved = is_true(one);
    } else if (name == "disableFixedJointLumping") {
      joint.is_locked_axis = is_true(one);
    } else if (name == "springStiffness") {
      set_number(context, one, Range::kFinite,
                 [&joint](double value) { joint.axis.spring_stiffness = value; });
    } else if (name == "springReference") {
      set_number(context, one, Range::kFinite,
                 [&joint](double value) { joint.axis.spring_reference = value; });
    } else if (name == "sensor" && context.spend(one)) {
      joint.sensors.push_back(read_sensor(context, one, scope, joint.name, pose));
    }
  }
}

/// All links and joints where they are before lumping, for poses of sensors with `relative_to`.
Scope scope_of(Context& context, const UrdfRobot& robot) {
  Scope scope("__model__");
  for (const UrdfLink& link : robot.links) {
    if (link.link.name == "world") {
      continue;
    }
    Scope::Entry entry;
    entry.name = link.link.name;
    entry.kind = Scope::Kind::kLink;
    entry.where = link.where;
    entry.pose.pose = link.in_root;
    scope.add(context, std::move(entry));
  }
  for (const UrdfJoint& joint : robot.joints) {
    Scope::Entry entry;
    entry.name = joint.name;
    entry.where = joint.where;
    entry.attached_to = robot.links[joint.child].link.name;
    // A link and a joint may have the same name in URDF; the link counts.
    if (!scope.has(entry.name)) {
      scope.add(context, std::move(entry));
    }
  }
  scope.resolve(context, robot.links[robot.root].link.name);
  return scope;
}

void report_unknown(Context& context, const Node& tag, const std::string& name,
                    const UrdfRobot& robot) {
  const auto names = [&robot] {
    std::vector<std::string> result;
    for (const UrdfLink& link : robot.links) {
      result.push_back(link.link.name);
    }
    for (const UrdfJoint& joint : robot.joints) {
      result.push_back(joint.name);
    }
    return result;
  };
  context.warning(tag, "<gazebo reference=\"" + name +
                           "\"> names no link or joint of the robot, so it is skipped" +
                           context.hint(name, names));
}

}  // namespace

void apply_references(Context& context, const Node& robot, UrdfRobot& value) {
  const Scope scope = scope_of(context, value);
  for (const Node& tag : children(robot, "gazebo")) {
    const std::string name = trimmed(attribute(tag, "reference"));
    if (name.empty()) {
      continue;
    }
    const auto link = value.link_index.find(name);
    const auto joint = value.joint_index.find(name);
    if (link != value.link_index.end()) {
      LinkTags(context, scope, value.links[link->second]).apply(tag);
    }
    if (joint != value.joint_index.end()) {
      UrdfJoint& one = value.joints[joint->second];
      apply_joint_tag(context, tag, scope, value.links[one.child].in_root, one);
    }
    if (link == value.link_index.end() && joint == value.joint_index.end()) {
      report_unknown(context, tag, name, value);
    }
  }
}

void apply_model_tags(Context& context, const Node& robot, const Scope& scope, Model& model) {
  for (const Node& tag : children(robot, "gazebo")) {
    if (!trimmed(attribute(tag, "reference")).empty()) {
      continue;
    }
    for (const Node& one : children(tag)) {
      const std::string& name = one.element->name;
      if (name == "static") {
        model.is_static = is_true(one);
      } else if (name == "self_collide") {
        model.self_collide = is_true(one);
      } else if (name == "plugin" && context.spend(one)) {
        model.plugins.push_back(read_plugin(context, one));
      } else if (name == "joint" && context.spend(one)) {
        if (required_name(context, one).empty()) {
          continue;
        }
        if (auto joint = read_joint(context, one, scope)) {
          model.joints.push_back(std::move(*joint));
        }
      } else if (name == "sensor" || name == "link" || name == "model" || name == "include") {
        const bool is_sensor = name == "sensor";
        context.warning(one, "<" + name + "> in a <gazebo> without `reference` is skipped" +
                                 (is_sensor ? ": write <gazebo reference=\"LINK\">" : ""));
      }
    }
  }
}

}  // namespace ros2wasm_sim
