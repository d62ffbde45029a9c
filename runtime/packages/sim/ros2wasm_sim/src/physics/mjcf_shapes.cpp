// See mjcf_shapes.hpp.
#include "physics/mjcf_shapes.hpp"

#include <algorithm>
#include <cstdio>

#include "mesh/heights.hpp"
#include "physics/mesh_pieces.hpp"

namespace ros2wasm_sim {
namespace {

/// Courses write 100000 for "does not slip"; above this the engine's wheels turn less exactly.
constexpr double kMostFriction = 2;

/// A slab of a mesh counts as ground, on which treads of wheels roll, when the upward part of its
/// normal is larger than this.
constexpr double kGroundSlope = 0.9;

// Bits beyond the sixteen of SDF. The tread of a wheel meets planes only, the wheel's own cylinder
// everything else.
constexpr std::uint32_t kTread = 1U << 16;
constexpr std::uint32_t kWheel = 1U << 17;
constexpr std::uint32_t kGround = 1U << 18;

double friction_of(const Surface& surface) {
  return std::clamp(surface.mu, 0.0, kMostFriction);
}

/// The rotation that turns z into a direction of length 1.
Quaternion towards(const Vector3& direction) {
  const Vector3 z{0, 0, 1};
  const double cosine = dot(z, direction);
  if (cosine < -1 + 1e-12) return {0, 1, 0, 0};
  const Vector3 axis = cross(z, direction);
  const Quaternion q{1 + cosine, axis.x, axis.y, axis.z};
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / size, q.x / size, q.y / size, q.z / size};
}

/// A wheel: a cylinder that turns freely about its own axis.
bool is_wheel(const Collision& shape, const Joint* joint) {
  const auto* cylinder = std::get_if<Cylinder>(&shape.geometry);
  if (cylinder == nullptr || joint == nullptr || joint->type != JointType::kRevolute) return false;
  if (joint->axes.empty() || std::isfinite(joint->axes[0].lower)) return false;
  const Vector3 axis = rotate(joint->pose.orientation, joint->axes[0].xyz);
  const Vector3 own = rotate(shape.pose.orientation, {0, 0, 1});
  const Vector3 offset = cross(shape.pose.position - joint->pose.position, axis);
  return length(cross(axis, own)) < 1e-3 && length(offset) < 1e-3 * cylinder->radius + 1e-9;
}

/// The engine refuses a shape that is flat in some direction.
bool has_size(const Geometry& geometry) {
  if (const auto* box = std::get_if<Box>(&geometry))
    return box->size.x > 0 && box->size.y > 0 && box->size.z > 0;
  if (const auto* one = std::get_if<Cylinder>(&geometry)) return one->radius > 0 && one->length > 0;
  if (const auto* one = std::get_if<Capsule>(&geometry)) return one->radius > 0 && one->length > 0;
  if (const auto* one = std::get_if<Sphere>(&geometry)) return one->radius > 0;
  if (const auto* one = std::get_if<Ellipsoid>(&geometry))
    return one->radii.x > 0 && one->radii.y > 0 && one->radii.z > 0;
  return true;
}

/// Remembers a geom whose friction has a direction.
void note_direction(const Collision& shape, const Link& link, const std::string& geom, Mjcf& mjcf) {
  const Surface& surface = shape.surface;
  const double size = length(surface.fdir1);
  if (size < 1e-9 || surface.mu == surface.mu2) return;
  DirectedShape one;
  one.geom = geom;
  one.body = static_cast<int>(mjcf.names.link_names.size()) - 1;
  one.mu = friction_of(surface);
  one.mu2 = std::clamp(surface.mu2, 0.0, kMostFriction);
  one.direction = 1 / size * surface.fdir1;
  one.frame = surface.fdir1_frame;
  if (one.frame.empty()) {
    one.frame = link.name;
    one.direction = rotate(shape.pose.orientation, one.direction);
  }
  mjcf.names.directed.push_back(one);
}

/// The same mesh: by its file, part and scale.
std::string key_of(const Mesh& mesh) {
  return part_key(mesh) + "\n" + text(mesh.scale);
}

std::string bits(std::uint32_t type, std::uint32_t affinity) {
  return " contype=\"" + std::to_string(static_cast<std::int32_t>(type)) + "\" conaffinity=\"" +
         std::to_string(static_cast<std::int32_t>(affinity)) + "\"";
}

}  // namespace

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string text(const Vector3& v) {
  return number(v.x) + " " + number(v.y) + " " + number(v.z);
}

std::string placed(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return " pos=\"" + text(pose.position) + "\" quat=\"" + number(q.w) + " " + number(q.x) + " " +
         number(q.y) + " " + number(q.z) + "\"";
}

ShapeWriter::ShapeWriter(const World& world, const MeshReader& meshes)
    : meshes_(meshes), step_(world.physics.max_step_size) {
  for (const Model& model : world.models)
    for (const Link& link : model.links)
      for (const Collision& shape : link.collisions) priorities_[friction_of(shape.surface)] = 0;
  // In a pair the geom of the higher priority decides: so the smaller friction does, as in Gazebo.
  int rank = static_cast<int>(priorities_.size());
  for (auto& [mu, priority] : priorities_) priority = rank--;
}

int ShapeWriter::priority(double mu) const {
  return priorities_.at(mu);
}

std::string ShapeWriter::shapes_of(const Link& link, const Mount& mount, Mjcf& mjcf) {
  std::string geoms;
  for (const Collision& shape : link.collisions) geoms += collision(shape, link, mount, mjcf);
  for (const Visual& shape : link.visuals) geoms += visual(shape, mjcf);
  return geoms;
}

std::string ShapeWriter::collision(const Collision& shape, const Link& link, const Mount& mount,
                                   Mjcf& mjcf) {
  const std::string what = "collision `" + shape.name + "` of link `" + link.name + "`";
  const std::string where = form(shape.geometry, shape.pose, mount.moves, what, mjcf);
  if (where.empty()) return {};
  const std::string name = "c" + std::to_string(mjcf.names.collisions.size());
  const std::string& model = mjcf.names.link_names.back().first;
  mjcf.names.collisions.push_back(model + "::" + link.name + "::" + shape.name);
  const auto geom = [&](const std::string& form, std::uint32_t type, std::uint32_t affinity,
                        int group, const std::string& suffix = {}, const std::string& more = {}) {
    const double mu = friction_of(shape.surface);
    const std::string geom_name = name + suffix;
    note_direction(shape, link, geom_name, mjcf);
    return "<geom name=\"" + geom_name + "\"" + form + bits(type, affinity) + " group=\"" +
           std::to_string(group) + "\" priority=\"" + std::to_string(priority(mu)) +
           "\" friction=\"" + number(mu) + " .005 .0001\"" + more + "/>\n";
  };
  const Surface& surface = shape.surface;
  colliding_.insert(static_cast<int>(mjcf.names.link_names.size()) - 1);
  if (surface.collide_without_contact) return geom(where, 0, 0, kCollisionGroup);
  const bool is_ground = std::holds_alternative<Plane>(shape.geometry) ||
                         std::holds_alternative<Heightmap>(shape.geometry);
  if (is_ground) return geom(where, kGround, surface.collide_bitmask | kTread, kCollisionGroup);
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry); mesh != nullptr && !mount.moves) {
    const std::vector<Piece>& pieces = pieces_of(*mesh, what, mjcf);
    std::string geoms = pieces.empty() ? "" : geom(where, 0, 0, kCollisionGroup);  // for rays
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece& piece = pieces[i];
      const std::string form =
          (piece.asset.empty() ? " type=\"box\" size=\"" + text(0.5 * piece.box) + "\""
                               : " type=\"mesh\" mesh=\"" + piece.asset + "\"") +
          placed(shape.pose * piece.pose);
      const std::string suffix = "p" + std::to_string(i);
      const Pose in_world = mount.pose * shape.pose;
      const bool carries = rotate(in_world.orientation, piece.normal).z > kGroundSlope;
      geoms +=
          carries ? geom(form, kGround, surface.collide_bitmask | kTread, kContactOnlyGroup, suffix)
                  : geom(form, surface.category_bitmask, surface.collide_bitmask, kContactOnlyGroup,
                         suffix);
    }
    if (!pieces.empty()) return geoms;
  }
  if (!is_wheel(shape, mount.joint))
    return geom(where, surface.category_bitmask, surface.collide_bitmask, kCollisionGroup);
  // A cylinder scrubs on two edges when it turns; a sphere of its radius rolls on one point. It is
  // stiff, so that it does not sink in and slip.
  const Cylinder& wheel = std::get<Cylinder>(shape.geometry);
  const std::string tread =
      " type=\"sphere\" size=\"" + number(wheel.radius) + "\"" + placed({shape.pose.position, {}});
  return geom(where, kWheel, surface.collide_bitmask | kWheel, kCollisionGroup) +
         geom(tread, kTread, 0, kContactOnlyGroup, "t",
              " solmix=\"1000\" solref=\"" + number(2 * step_) + " 1\"");
}

std::string ShapeWriter::visual(const Visual& shape, Mjcf& mjcf) {
  Geometry geometry = shape.geometry;
  Pose pose = shape.pose;
  if (const auto* plane = std::get_if<Plane>(&shape.geometry)) {  // it is drawn as large as it is
    pose = pose * Pose{{}, towards(plane->normal)};
    geometry = Box{{plane->width, plane->height, 1e-4}};
  }
  const std::string where = form(geometry, pose, false, "visual `" + shape.name + "`", mjcf);
  if (where.empty()) return {};
  const Color& color = shape.material.diffuse;
  return "<geom" + where + bits(0, 0) + " group=\"" + std::to_string(kVisualGroup) + "\" rgba=\"" +
         number(color.r) + " " + number(color.g) + " " + number(color.b) + " 1\"/>\n";
}

std::string ShapeWriter::form(const Geometry& geometry, const Pose& pose, bool moves,
                              const std::string& what, Mjcf& mjcf) {
  if (!has_size(geometry)) {
    mjcf.warnings.push_back(what + " is skipped: it has no size");
    return {};
  }
  const auto with = [&](const std::string& type, const std::string& size) {
    return " type=\"" + type + "\" size=\"" + size + "\"" + placed(pose);
  };
  if (const auto* box = std::get_if<Box>(&geometry)) return with("box", text(0.5 * box->size));
  if (const auto* one = std::get_if<Cylinder>(&geometry))
    return with("cylinder", number(one->radius) + " " + number(one->length / 2));
  if (const auto* one = std::get_if<Sphere>(&geometry)) return with("sphere", number(one->radius));
  if (const auto* one = std::get_if<Capsule>(&geometry))
    return with("capsule", number(one->radius) + " " + number(one->length / 2));
  if (const auto* one = std::get_if<Ellipsoid>(&geometry))
    return with("ellipsoid", text(one->radii));
  if (const auto* plane = std::get_if<Plane>(&geometry)) {
    if (moves) {
      mjcf.warnings.push_back(what + " is skipped: a plane cannot move");
      return {};
    }
    return " type=\"plane\" size=\"0 0 1\"" + placed(pose * Pose{{}, towards(plane->normal)});
  }
  if (const auto* one = std::get_if<Mesh>(&geometry)) {
    const std::string name = mesh(*one, what, mjcf);
    if (name.empty()) return {};
    return " type=\"mesh\" mesh=\"" + name + "\"" + placed(pose);
  }
  if (const auto* map = std::get_if<Heightmap>(&geometry)) {
    if (moves) {
      mjcf.warnings.push_back(what + " is skipped: a heightmap cannot move");
      return {};
    }
    const std::string name = heights(mesh_of(*map), what, mjcf);
    if (name.empty()) return {};
    return " type=\"hfield\" hfield=\"" + name + "\"" + placed(pose * Pose{map->position, {}});
  }
  return {};
}

std::string ShapeWriter::heights(const Mesh& map, const std::string& what, Mjcf& mjcf) {
  const auto [known, is_new] = mesh_names_.try_emplace(key_of(map));
  std::string& name = known->second;
  if (!is_new) return name;
  const std::shared_ptr<const TriangleMesh> read = meshes_ ? meshes_(map) : nullptr;
  if (read == nullptr || read->columns == 0) {
    mjcf.warnings.push_back(what + " is skipped: its heightmap `" + map.uri + "` cannot be read");
    return name;
  }
  name = "heights" + std::to_string(mjcf.names.heights.size());
  mjcf.names.heights.push_back(read);
  // Half sizes, the height of 1, and how deep the ground is below 0.
  constexpr double kDepth = 1;
  assets_ += "<hfield name=\"" + name + "\" nrow=\"" + std::to_string(read->rows) + "\" ncol=\"" +
             std::to_string(read->columns) + "\" size=\"" + number(map.scale.x / 2) + " " +
             number(map.scale.y / 2) + " " + number(map.scale.z) + " " + number(kDepth) + "\"/>\n";
  return name;
}

std::string ShapeWriter::mesh(const Mesh& mesh, const std::string& what, Mjcf& mjcf) {
  const std::string key = key_of(mesh);
  const auto known = mesh_names_.find(key);
  if (known != mesh_names_.end()) return known->second;
  std::string& name = mesh_names_[key];
  const std::shared_ptr<const TriangleMesh> read = meshes_ ? meshes_(mesh) : nullptr;
  if (read == nullptr || read->faces.empty()) {
    mjcf.warnings.push_back(what + " is skipped: its mesh `" + mesh.uri + "` cannot be read");
    return name;
  }
  name = "mesh" + std::to_string(++assets_written_);
  mjcf.names.meshes[name] = mesh.path;
  const TriangleMesh solid = with_thickness(*read, mesh.scale);
  assets_ += "<mesh name=\"" + name + "\" scale=\"" + text(mesh.scale) + "\" vertex=\"";
  for (const float value : solid.vertices) assets_ += number(value) + " ";
  assets_ += "\" face=\"";
  for (const int value : solid.faces) assets_ += std::to_string(value) + " ";
  assets_ += "\"/>\n";
  return name;
}

const std::vector<ShapeWriter::Piece>& ShapeWriter::pieces_of(const Mesh& mesh,
                                                              const std::string& what, Mjcf& mjcf) {
  const auto [known, is_new] = pieces_.try_emplace(key_of(mesh));
  std::vector<Piece>& pieces = known->second;
  if (!is_new) return pieces;
  const std::vector<MeshPiece> parts = mesh_pieces(*meshes_(mesh), mesh.scale);
  if (parts.empty())
    mjcf.warnings.push_back(what + ": its mesh `" + mesh.uri + "` has more than " +
                            std::to_string(kMostPieces) +
                            " faces that are not part of something convex; what touches it meets "
                            "its convex hull. Boxes, or a coarser mesh for <collision>, are exact");
  if (parts.size() == 1 && parts.front().points.empty()) return pieces;
  for (const MeshPiece& part : parts) {
    if (part.box) {
      pieces.push_back({"", *part.box, part.pose, part.normal});
      continue;
    }
    pieces.push_back({"mesh" + std::to_string(++assets_written_), {}, {}, part.normal});
    mjcf.names.meshes[pieces.back().asset] = mesh.path;
    assets_ += "<mesh name=\"" + pieces.back().asset + "\" vertex=\"";
    for (const Vector3& point : part.points) assets_ += text(point) + " ";
    assets_ += "\"/>\n";
  }
  return pieces;
}

}  // namespace ros2wasm_sim
