// See sdf_geometry.hpp.
#include "sdf/sdf_geometry.hpp"

#include <algorithm>

namespace ros2wasm_sim {
namespace {

double positive(Context& context, const Node& shape, const std::string& name, double value) {
  return number(context, shape, name, value, Range::kPositive);
}

Geometry read_plane(Context& context, const Node& shape) {
  Plane plane;
  plane.normal = vector3(context, shape, "normal", plane.normal);
  const double size = length(plane.normal);
  if (size < 1e-9) {
    context.error(child(shape, "normal"), "<normal> has a length of zero");
    plane.normal = {0, 0, 1};
  } else {
    plane.normal = (1 / size) * plane.normal;
  }
  const Node node = child(shape, "size");
  const std::string text = text_of(node);
  if (!text.empty()) {
    if (const auto read = numbers(context, node, text, 2, "<size>", Range::kNotNegative)) {
      plane.width = (*read)[0];
      plane.height = (*read)[1];
    }
  }
  return plane;
}

Geometry read_mesh(Context& context, const Node& shape) {
  const Node uri = child(shape, "uri");
  if (text_of(uri).empty()) {
    context.error(shape, "<mesh> needs a <uri>");
    return NoGeometry{};
  }
  Mesh mesh = locate_mesh(context, uri, text_of(uri));
  mesh.scale = vector3(context, shape, "scale", mesh.scale);
  mesh.submesh = text_of(descend(shape, {"submesh", "name"}));
  mesh.center_submesh = boolean(context, child(shape, "submesh"), "center", false);
  return mesh;
}

Geometry read_heightmap(Context& context, const Node& shape) {
  Heightmap result;
  const Node uri = child(shape, "uri");
  result.uri = text_of(uri);
  if (result.uri.empty()) {
    context.error(shape, "<heightmap> needs a <uri>");
    return NoGeometry{};
  }
  result.path = context.find(result.uri, uri, "the heightmap");
  result.size = vector3(context, shape, "size", result.size, Range::kPositive);
  result.position = vector3(context, shape, "pos", result.position);
  return result;
}

Geometry read_shape(Context& context, const Node& shape) {
  const std::string& name = shape.element->name;
  if (name == "box") {
    return Box{vector3(context, shape, "size", {1, 1, 1}, Range::kNotNegative)};
  }
  if (name == "cylinder") {
    return Cylinder{positive(context, shape, "radius", 1), positive(context, shape, "length", 1)};
  }
  if (name == "sphere") {
    return Sphere{positive(context, shape, "radius", 1)};
  }
  if (name == "capsule") {
    return Capsule{positive(context, shape, "radius", 0.5), positive(context, shape, "length", 1)};
  }
  if (name == "ellipsoid") {
    return Ellipsoid{vector3(context, shape, "radii", {1, 1, 1}, Range::kPositive)};
  }
  if (name == "plane") {
    return read_plane(context, shape);
  }
  if (name == "mesh") {
    return read_mesh(context, shape);
  }
  if (name == "heightmap") {
    return read_heightmap(context, shape);
  }
  if (name != "empty") {
    context.warning_once(shape, "the shape <" + name + "> is not supported and is skipped");
  }
  return NoGeometry{};
}

std::uint32_t bitmask(Context& context, const Node& contact, const std::string& name,
                      std::uint32_t value) {
  const Node node = child(contact, name);
  const std::string text = text_of(node);
  if (text.empty()) {
    return value;
  }
  const bool is_hexadecimal = text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X";
  const std::string digits = text.substr(is_hexadecimal ? 2 : 0);
  const char* allowed = is_hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";
  if (digits.empty() || digits.size() > 10 ||
      digits.find_first_not_of(allowed) != std::string::npos) {
    context.error(node, "<" + name + "> is not a 32-bit number, such as 0x01 or 65535");
    return value;
  }
  const unsigned long long bits = std::stoull(digits, nullptr, is_hexadecimal ? 16 : 10);
  return static_cast<std::uint32_t>(std::min(bits, 0xFFFFFFFFULL));
}

}  // namespace

Mesh locate_mesh(Context& context, const Node& where, const std::string& uri) {
  Mesh mesh;
  mesh.uri = uri;
  mesh.path = context.find(uri, where, "the mesh");
  return mesh;
}

Geometry read_geometry(Context& context, const Node& parent) {
  const Node geometry = child(parent, "geometry");
  if (!geometry) {
    context.error(parent, "<" + parent.element->name + "> needs a <geometry>");
    return NoGeometry{};
  }
  const std::vector<Node> shapes = children(geometry);
  return shapes.empty() ? Geometry{NoGeometry{}} : read_shape(context, shapes.front());
}

void read_surface(Context& context, const Node& surface, Surface& value) {
  const Node friction = child(surface, "friction");
  // Values for bullet count only where there are none for ode.
  const Node bullet = child(friction, "bullet");
  value.mu = number(context, bullet, "friction", value.mu, Range::kNotNegative);
  value.mu2 = number(context, bullet, "friction2", value.mu2, Range::kNotNegative);
  const Node ode = child(friction, "ode");
  value.mu = number(context, ode, "mu", value.mu, Range::kNotNegative);
  value.mu2 = number(context, ode, "mu2", value.mu2, Range::kNotNegative);
  value.fdir1 = vector3(context, ode, "fdir1", value.fdir1);
  for (const char* name : {"gz:expressed_in", "ignition:expressed_in"})
    if (const std::string frame = attribute(child(ode, "fdir1"), name); !frame.empty())
      value.fdir1_frame = frame;
  value.torsional = number(context, child(friction, "torsional"), "coefficient", value.torsional,
                           Range::kNotNegative);
  value.restitution = number(context, child(surface, "bounce"), "restitution_coefficient",
                             value.restitution, Range::kNotNegative);
  const Node contact = child(surface, "contact");
  value.collide_bitmask = bitmask(context, contact, "collide_bitmask", value.collide_bitmask);
  value.category_bitmask = bitmask(context, contact, "category_bitmask", value.category_bitmask);
  value.collide_without_contact =
      boolean(context, contact, "collide_without_contact", value.collide_without_contact);
}

}  // namespace ros2wasm_sim
