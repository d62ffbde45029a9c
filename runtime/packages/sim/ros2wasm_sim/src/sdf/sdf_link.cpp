// See sdf_link.hpp.
#include "sdf/sdf_link.hpp"

#include <unordered_set>

#include "sdf/inertia.hpp"
#include "sdf/sdf_geometry.hpp"
#include "sdf/sdf_material.hpp"

namespace ros2wasm_sim {
namespace {

/// The pose of something in a link, in that link.
Pose pose_in_link(Context& context, const RawPose& raw, const Scope& scope, const Pose& link) {
  if (raw.relative_to.empty()) {
    return raw.pose;
  }
  return inverse(link) * scope.pose_in_root(context, raw, "");
}

Collision read_collision(Context& context, const Node& node, const Scope& scope, const Pose& link) {
  Collision result;
  result.name = required_name(context, node);
  result.pose = pose_in_link(context, raw_pose(context, node), scope, link);
  result.geometry = read_geometry(context, node);
  read_surface(context, child(node, "surface"), result.surface);
  return result;
}

Visual read_visual(Context& context, const Node& node, const Scope& scope, const Pose& link) {
  Visual result;
  result.name = required_name(context, node);
  result.pose = pose_in_link(context, raw_pose(context, node), scope, link);
  result.geometry = read_geometry(context, node);
  read_visual_properties(context, node, result);
  return result;
}

/// The mass and moments of the collisions, of an <inertial auto="true">.
Inertial automatic_inertial(Context& context, const Node& node, const Node& link,
                            const std::vector<Collision>& collisions) {
  const double by_default = number(context, node, "density", 1000, Range::kPositive);
  const std::vector<Node> elements = children(link, "collision");
  std::vector<Inertial> bodies;
  for (std::size_t i = 0; i < collisions.size() && i < elements.size(); ++i) {
    const double density = number(context, elements[i], "density", by_default, Range::kPositive);
    std::optional<Inertial> body = solid(collisions[i].geometry, density);
    if (!body) {
      context.warning(elements[i],
                      "the mass of this collision is not computed, since its shape is "
                      "not solid: only boxes, cylinders, spheres, capsules and "
                      "ellipsoids are");
      continue;
    }
    body->pose = collisions[i].pose;
    bodies.push_back(*body);
  }
  if (bodies.empty()) {
    context.error(node, "<inertial auto=\"true\"> needs a collision with a solid shape");
    return Inertial();
  }
  Inertial result = combined(bodies);
  const bool has_mass = node.source->minor_version >= 12 && !text_of(node, "mass").empty();
  const double mass =
      has_mass ? number(context, node, "mass", result.mass, Range::kPositive) : result.mass;
  const double scale = result.mass > 0 ? mass / result.mass : 1;
  result.mass = mass;
  for (double Inertial::*moment : {&Inertial::ixx, &Inertial::iyy, &Inertial::izz, &Inertial::ixy,
                                   &Inertial::ixz, &Inertial::iyz}) {
    result.*moment *= scale;
  }
  return result;
}

Inertial read_inertial(Context& context, const Node& link, const Scope& scope, const Link& value) {
  Inertial result;
  const Node node = child(link, "inertial");
  if (!node) {
    return result;
  }
  const std::string automatic = attribute(node, "auto");
  if (automatic == "true" || automatic == "1") {
    return automatic_inertial(context, node, link, value.collisions);
  }
  result.mass = number(context, node, "mass", result.mass);
  result.pose = pose_in_link(context, raw_pose(context, node), scope, value.pose);
  const Node inertia = child(node, "inertia");
  result.ixx = number(context, inertia, "ixx", result.ixx);
  result.iyy = number(context, inertia, "iyy", result.iyy);
  result.izz = number(context, inertia, "izz", result.izz);
  result.ixy = number(context, inertia, "ixy", result.ixy);
  result.ixz = number(context, inertia, "ixz", result.ixz);
  result.iyz = number(context, inertia, "iyz", result.iyz);
  return result;
}

template <typename T>
void warn_of_name_twice(Context& context, const Node& node, const T& value,
                        std::unordered_set<std::string>& names) {
  if (!value.name.empty() && !names.insert(value.name).second) {
    context.warning(node,
                    "the link has two <" + node.element->name + "> elements `" + value.name + "`");
  }
}

void read_shapes(Context& context, const Node& node, const Scope& scope, Link& link) {
  std::unordered_set<std::string> collisions, visuals;
  for (const Node& one : children(node)) {
    const std::string& kind = one.element->name;
    if (kind != "collision" && kind != "visual" && kind != "sensor" && kind != "light") {
      continue;
    }
    if (!context.spend(one)) {
      return;
    }
    if (kind == "collision") {
      link.collisions.push_back(read_collision(context, one, scope, link.pose));
      warn_of_name_twice(context, one, link.collisions.back(), collisions);
    } else if (kind == "visual") {
      link.visuals.push_back(read_visual(context, one, scope, link.pose));
      warn_of_name_twice(context, one, link.visuals.back(), visuals);
    } else if (kind == "sensor") {
      link.sensors.push_back(read_sensor(context, one, scope, link.name, link.pose));
    } else {
      Light light = read_light(context, one);
      light.pose = pose_in_link(context, raw_pose(context, one), scope, link.pose);
      link.lights.push_back(std::move(light));
    }
  }
}

}  // namespace

Link read_link(Context& context, const Node& node, const Scope& scope, bool is_static) {
  Link link;
  link.name = attribute(node, "name");
  if (const std::optional<Place> place = scope.find(link.name)) {
    link.pose = place->pose;
  }
  link.gravity = boolean(context, node, "gravity", link.gravity);
  link.kinematic = boolean(context, node, "kinematic", link.kinematic);
  link.self_collide = boolean(context, node, "self_collide", link.self_collide);
  read_shapes(context, node, scope, link);
  link.inertial = read_inertial(context, node, scope, link);
  if (!is_static && child(node, "inertial")) {
    check_inertial(context, child(node, "inertial"), link.name, link.inertial);
  }
  return link;
}

void check_inertial(Context& context, const Node& where, const std::string& link,
                    const Inertial& inertial) {
  if (!(inertial.mass > 0)) {
    context.error(where, "the mass of the link `" + link + "` must be greater than 0");
  } else if (!is_possible(inertial)) {
    context.warning(where, "the moments of inertia of the link `" + link +
                               "` are not possible: each must be greater than 0 and at most the "
                               "sum of the other two. The link may move in a strange way");
  }
}

void read_visual_properties(Context& context, const Node& node, Visual& visual) {
  if (const Node material = child(node, "material")) {
    visual.material = read_material(context, material);
  }
  visual.transparency =
      number(context, node, "transparency", visual.transparency, Range::kNotNegative);
  visual.transparency = visual.transparency > 1 ? 1 : visual.transparency;
  visual.cast_shadows = boolean(context, node, "cast_shadows", visual.cast_shadows);
}

Sensor read_sensor(Context& context, const Node& node, const Scope& scope, const std::string& link,
                   const Pose& pose) {
  Sensor result;
  result.name = required_name(context, node);
  result.type = attribute(node, "type");
  if (result.type.empty()) {
    context.error(node,
                  "the sensor `" + result.name + "` of `" + link + "` needs the attribute `type`");
  }
  result.pose = pose_in_link(context, raw_pose(context, node), scope, pose);
  result.update_rate = number(context, node, "update_rate", 0, Range::kNotNegative);
  result.always_on = boolean(context, node, "always_on", false);
  result.visualize = boolean(context, node, "visualize", false);
  result.topic = text_of(node, "topic");
  const std::string frame = text_of(node, "gz_frame_id");
  result.frame_id = frame.empty() ? text_of(node, "ignition_frame_id") : frame;
  result.xml = view_of(node);
  for (const Node& plugin : children(node, "plugin")) {
    if (context.spend(plugin)) {
      result.plugins.push_back(read_plugin(context, plugin));
    }
  }
  return result;
}

Light read_light(Context& context, const Node& node) {
  Light light;
  light.name = required_name(context, node);
  const std::string type = attribute(node, "type");
  if (!type.empty() && type != "point" && type != "directional" && type != "spot") {
    context.error(node, "the light `" + light.name + "` is of the unknown type `" + type +
                            "`: types are point, directional and spot");
  }
  light.type = type.empty() ? light.type : type;
  light.diffuse = color(context, node, "diffuse", light.diffuse);
  light.specular = color(context, node, "specular", light.specular);
  light.direction = vector3(context, node, "direction", light.direction);
  light.intensity = number(context, node, "intensity", light.intensity, Range::kNotNegative);
  light.cast_shadows = boolean(context, node, "cast_shadows", light.cast_shadows);
  const Node attenuation = child(node, "attenuation");
  const auto fade = [&](const char* name, double otherwise) {
    return number(context, attenuation, name, otherwise, Range::kNotNegative);
  };
  light.range = fade("range", light.range);
  light.constant = fade("constant", light.constant);
  light.linear = fade("linear", light.linear);
  light.quadratic = fade("quadratic", light.quadratic);
  const Node spot = child(node, "spot");
  light.inner_angle = number(context, spot, "inner_angle", light.inner_angle);
  light.outer_angle = number(context, spot, "outer_angle", light.outer_angle);
  return light;
}

Plugin read_plugin(Context& context, const Node& node) {
  Plugin plugin;
  plugin.name = attribute(node, "name");
  plugin.filename = attribute(node, "filename");
  if (plugin.filename.empty()) {
    context.warning(node, "the plugin `" + plugin.name + "` has no attribute `filename`");
  }
  plugin.xml = view_of(node);
  return plugin;
}

}  // namespace ros2wasm_sim
