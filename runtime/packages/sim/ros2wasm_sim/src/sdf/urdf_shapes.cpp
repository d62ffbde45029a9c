// See urdf_shapes.hpp.
#include "sdf/urdf_shapes.hpp"

#include <algorithm>

#include "sdf/sdf_geometry.hpp"
#include "sdf/sdf_material.hpp"

namespace ros2wasm_sim {
namespace {

Vector3 triple(Context& context, const Node& node, const std::string& name, const Vector3& value,
               Range range = Range::kFinite) {
  if (!has_attribute(node, name)) {
    return value;
  }
  const auto read = numbers(context, node, attribute(node, name), 3, "`" + name + "`", range);
  return read ? Vector3{(*read)[0], (*read)[1], (*read)[2]} : value;
}

Geometry urdf_geometry(Context& context, const Node& parent) {
  const Node geometry = child(parent, "geometry");
  const std::vector<Node> shapes = children(geometry);
  if (shapes.empty()) {
    context.error(parent, "<" + parent.element->name + "> needs a <geometry> with a shape");
    return NoGeometry{};
  }
  const Node& shape = shapes.front();
  const std::string& name = shape.element->name;
  const auto positive = [&](const std::string& key) {
    return urdf_number(context, shape, key, std::nullopt, Range::kPositive);
  };
  if (name == "box") {
    if (!has_attribute(shape, "size")) {
      context.error(shape, "<box> needs the attribute `size`");
    }
    return Box{triple(context, shape, "size", {1, 1, 1}, Range::kNotNegative)};
  }
  if (name == "cylinder") {
    return Cylinder{positive("radius"), positive("length")};
  }
  if (name == "sphere") {
    return Sphere{positive("radius")};
  }
  if (name == "capsule") {
    return Capsule{positive("radius"), positive("length")};
  }
  if (name != "mesh") {
    context.error(
        shape, "<" + name +
                   "> is not a shape of URDF: shapes are box, cylinder, sphere, capsule and mesh");
    return NoGeometry{};
  }
  const std::string uri = trimmed(attribute(shape, "filename"));
  if (uri.empty()) {
    context.error(shape, "<mesh> needs the attribute `filename`");
    return NoGeometry{};
  }
  Mesh mesh = locate_mesh(context, shape, uri);
  mesh.scale = triple(context, shape, "scale", mesh.scale);
  return mesh;
}

/// As SDFormat makes it of a URDF's colour: brighter by a quarter.
Material material_of_color(const std::vector<double>& rgba) {
  const auto brighter = [&rgba](std::size_t i) { return std::clamp(rgba[i] / 0.8, 0.0, 1.0); };
  return plain_material({brighter(0), brighter(1), brighter(2), std::clamp(rgba[3], 0.0, 1.0)});
}

std::optional<Material> own_material(Context& context, const Node& node) {
  std::optional<Material> result;
  const Node color = child(node, "color");
  if (color) {
    const std::string rgba = attribute(color, "rgba");
    if (const auto read = numbers(context, color, rgba, 4, "`rgba`", Range::kFinite)) {
      result = material_of_color(*read);
    }
  }
  const Node texture = child(node, "texture");
  const std::string uri = attribute(texture, "filename");
  if (!uri.empty()) {
    result = result ? result : plain_material({1, 1, 1, 1});
    result->texture = context.find(uri, texture, "the texture");
  }
  return result;
}

}  // namespace

Pose urdf_origin(Context& context, const Node& parent) {
  const Node origin = child(parent, "origin");
  Pose pose;
  pose.position = triple(context, origin, "xyz", {});
  const Vector3 rpy = triple(context, origin, "rpy", {});
  pose.orientation = from_roll_pitch_yaw(rpy.x, rpy.y, rpy.z);
  return pose;
}

double urdf_number(Context& context, const Node& node, const std::string& name,
                   std::optional<double> by_default, Range range) {
  if (has_attribute(node, name)) {
    const std::string text = attribute(node, name);
    return checked_number(context, node, text, "`" + name + "`", range)
        .value_or(by_default.value_or(1));
  }
  if (!by_default) {
    context.error(node, "<" + node.element->name + "> needs the attribute `" + name + "`");
  }
  return by_default.value_or(1);
}

std::optional<Inertial> urdf_inertial(Context& context, const Node& link) {
  const Node node = child(link, "inertial");
  if (!node) {
    return std::nullopt;
  }
  const Node mass = child(node, "mass");
  const Node inertia = child(node, "inertia");
  if (!mass || !inertia) {
    context.error(node, "the <inertial> of the link `" + attribute(link, "name") + "` needs a <" +
                            (mass ? "inertia" : "mass") + ">");
    return std::nullopt;
  }
  Inertial result;
  result.pose = urdf_origin(context, node);
  result.mass = urdf_number(context, mass, "value", std::nullopt);
  result.ixx = urdf_number(context, inertia, "ixx", std::nullopt);
  result.iyy = urdf_number(context, inertia, "iyy", std::nullopt);
  result.izz = urdf_number(context, inertia, "izz", std::nullopt);
  result.ixy = urdf_number(context, inertia, "ixy", std::nullopt);
  result.ixz = urdf_number(context, inertia, "ixz", std::nullopt);
  result.iyz = urdf_number(context, inertia, "iyz", std::nullopt);
  return result;
}

UrdfMaterials urdf_materials(Context& context, const Node& robot) {
  UrdfMaterials result;
  const auto add = [&](const Node& node) {
    const std::string name = attribute(node, "name");
    if (name.empty() || result.count(name) != 0) {
      return;
    }
    if (const auto material = own_material(context, node)) {
      result[name] = *material;
    }
  };
  for (const Node& node : children(robot, "material")) {
    add(node);
  }
  // A visual may define what others name.
  for (const Node& link : children(robot, "link")) {
    for (const Node& visual : children(link, "visual")) {
      if (const Node material = child(visual, "material")) {
        add(material);
      }
    }
  }
  return result;
}

Collision urdf_collision(Context& context, const Node& node) {
  Collision result;
  result.name = attribute(node, "name");
  result.pose = urdf_origin(context, node);
  result.geometry = urdf_geometry(context, node);
  return result;
}

Visual urdf_visual(Context& context, const Node& node, const UrdfMaterials& materials) {
  Visual result;
  result.name = attribute(node, "name");
  result.pose = urdf_origin(context, node);
  result.geometry = urdf_geometry(context, node);
  const Node material = child(node, "material");
  if (!material) {
    return result;
  }
  const std::string name = attribute(material, "name");
  const auto found = materials.find(name);
  if (child(material, "color") || child(material, "texture")) {
    result.material = own_material(context, material).value_or(Material());
  } else if (found != materials.end()) {
    result.material = found->second;
  } else {
    context.warning_once(material,
                         "the material `" + name + "` has no colour anywhere in the URDF");
  }
  return result;
}

}  // namespace ros2wasm_sim
