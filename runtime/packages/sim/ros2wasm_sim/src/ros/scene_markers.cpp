// See scene_markers.hpp.
#include "ros/scene_markers.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mesh/heights.hpp"
#include "plugins/messages.hpp"

namespace ros2wasm_sim {
namespace {

using visualization_msgs::msg::Marker;

/// More the page does not draw.
constexpr std::size_t kMostMarkers = 5000;
/// Corners of all lists of triangles of a message: 24 bytes each.
constexpr std::size_t kMostPoints = 150'000;
constexpr std::size_t kMostContacts = 500;
constexpr std::size_t kMostLights = 100;
/// How a force is drawn.
constexpr double kMetresPerNewton = 0.02, kLongestForce = 1;
/// How thick a plane is drawn, in metres, below its surface.
constexpr double kPlaneThickness = 0.002;

/// A rotation that turns z to this direction of length 1.
Quaternion from_z_to(const Vector3& direction) {
  if (direction.z < -1 + 1e-9) return {0, 1, 0, 0};
  const Quaternion half{1 + direction.z, -direction.y, direction.x, 0};
  const double size = std::sqrt(half.w * half.w + half.x * half.x + half.y * half.y);
  return {half.w / size, half.x / size, half.y / size, 0};
}

/// A rotation that turns x to this direction of length 1.
Quaternion from_x_to(const Vector3& direction) {
  if (direction.x < -1 + 1e-9) return {0, 0, 0, 1};
  const Quaternion half{1 + direction.x, 0, -direction.z, direction.y};
  const double size = std::sqrt(half.w * half.w + half.y * half.y + half.z * half.z);
  return {half.w / size, 0, half.y / size, half.z / size};
}

class Writer {
 public:
  explicit Writer(const MeshReader& meshes) : meshes_(meshes) {
    Marker clear;
    clear.action = Marker::DELETEALL;
    result_.message.markers.push_back(clear);
  }

  void begin_link(const std::string& frame, bool moves) {
    frame_ = frame;
    moves_ = moves;
  }

  /// One shape: a marker, or several for those that have no marker of their own.
  void add(const std::string& name, const Pose& pose, const Geometry& geometry, const Color& color,
           bool own_materials) {
    name_ = name;
    color_ = color;
    own_materials_ = own_materials;
    std::visit([&](const auto& shape) { draw(shape, pose); }, geometry);
  }

  SceneMarkers take() { return std::move(result_); }

 private:
  Marker* put(int type, const Pose& pose, const Vector3& scale) {
    auto& markers = result_.message.markers;
    if (markers.size() > kMostMarkers) {
      ++result_.skipped;
      return nullptr;
    }
    Marker marker;
    marker.header.frame_id = frame_;
    marker.frame_locked = moves_;
    marker.ns = frame_;
    marker.id = static_cast<int>(markers.size());
    marker.type = type;
    marker.text = name_;
    marker.pose = pose_message(pose);
    marker.scale = vector_message(scale);
    marker.color.r = static_cast<float>(color_.r);
    marker.color.g = static_cast<float>(color_.g);
    marker.color.b = static_cast<float>(color_.b);
    marker.color.a = static_cast<float>(color_.a);
    markers.push_back(std::move(marker));
    return &markers.back();
  }

  void draw(const NoGeometry&, const Pose&) {}
  void draw(const Box& box, const Pose& pose) { put(Marker::CUBE, pose, box.size); }
  void draw(const Cylinder& one, const Pose& pose) {
    put(Marker::CYLINDER, pose, {2 * one.radius, 2 * one.radius, one.length});
  }
  void draw(const Sphere& one, const Pose& pose) {
    put(Marker::SPHERE, pose, {2 * one.radius, 2 * one.radius, 2 * one.radius});
  }
  void draw(const Capsule& one, const Pose& pose) {
    draw(Cylinder{one.radius, one.length}, pose);
    for (const double end : {-0.5, 0.5})
      draw(Sphere{one.radius}, pose * Pose{{0, 0, end * one.length}, {}});
  }
  void draw(const Ellipsoid& one, const Pose& pose) { put(Marker::SPHERE, pose, 2.0 * one.radii); }
  void draw(const Plane& plane, const Pose& pose) {
    const Pose turned = pose * Pose{{}, from_z_to(plane.normal)};
    put(Marker::CUBE, turned * Pose{{0, 0, -kPlaneThickness / 2}, {}},
        {plane.width, plane.height, kPlaneThickness});
  }
  void draw(const Heightmap& map, const Pose& pose) {
    if (!map.path.empty()) draw_part(mesh_of(map), pose * Pose{map.position, {}});
  }

  void draw(const Mesh& mesh, const Pose& pose) {
    if (mesh.path.empty()) return;
    if (!mesh.submesh.empty()) return draw_part(mesh, pose);
    if (Marker* marker = put(Marker::MESH_RESOURCE, pose, mesh.scale)) {
      marker->mesh_resource = "file://" + mesh.path;
      marker->mesh_use_embedded_materials = own_materials_;
    }
  }

  /// A marker names whole files only, so a part of one is sent as triangles.
  void draw_part(const Mesh& mesh, const Pose& pose) {
    const auto part = meshes_(mesh);
    if (!part) return;
    if (points_ + part->faces.size() > kMostPoints) {
      ++result_.skipped;
      return;
    }
    Marker* marker = put(Marker::TRIANGLE_LIST, pose, mesh.scale);
    if (marker == nullptr) return;
    points_ += part->faces.size();
    for (const int corner : part->faces) {
      geometry_msgs::msg::Point point;
      point.x = part->vertices[3 * corner];
      point.y = part->vertices[3 * corner + 1];
      point.z = part->vertices[3 * corner + 2];
      marker->points.push_back(point);
    }
  }

  const MeshReader& meshes_;
  SceneMarkers result_;
  std::string frame_, name_;
  Color color_;
  bool own_materials_ = false;
  bool moves_ = true;
  std::size_t points_ = 0;
};

/// A plane would dye everything that is seen through it.
Color collision_color(const Geometry& geometry) {
  return {1, 0.55, 0, std::holds_alternative<Plane>(geometry) ? 0.08 : 0.4};
}

geometry_msgs::msg::Point point_message(const Vector3& place) {
  geometry_msgs::msg::Point point;
  point.x = place.x;
  point.y = place.y;
  point.z = place.z;
  return point;
}

Marker light_marker(const Light& light, const std::string& frame, int id) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.frame_locked = true;
  marker.ns = light.type;
  marker.id = id;
  marker.type = Marker::ARROW;
  marker.text = light.name;
  const double size = length(light.direction);
  const Vector3 direction = size > 0 ? (1 / size) * light.direction : Vector3{0, 0, -1};
  marker.pose = pose_message(light.pose * Pose{{}, from_x_to(direction)});
  marker.scale = vector_message({light.range, light.outer_angle, light.inner_angle});
  marker.color.r = static_cast<float>(light.diffuse.r * light.intensity);
  marker.color.g = static_cast<float>(light.diffuse.g * light.intensity);
  marker.color.b = static_cast<float>(light.diffuse.b * light.intensity);
  marker.color.a = 1;
  marker.points = {point_message({light.constant, light.linear, light.quadratic})};
  marker.mesh_use_embedded_materials = light.cast_shadows;
  return marker;
}

Marker contacts_marker(int id, int type, double size) {
  Marker marker;
  marker.header.frame_id = "world";
  marker.ns = "contacts";
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = size;
  marker.color.r = 0.9F;
  marker.color.g = 0.2F;
  marker.color.b = 0.6F;
  marker.color.a = 1;
  return marker;
}

}  // namespace

visualization_msgs::msg::MarkerArray light_markers(const World& world) {
  visualization_msgs::msg::MarkerArray message;
  message.markers.emplace_back().action = Marker::DELETEALL;
  const auto add = [&message](const std::vector<Light>& lights, const std::string& frame) {
    for (const Light& light : lights) {
      const std::size_t id = message.markers.size();
      if (id > kMostLights) return;
      message.markers.push_back(light_marker(light, frame, static_cast<int>(id)));
    }
  };
  add(world.lights, "world");
  for (const Model& model : world.models)
    for (const Link& link : model.links) add(link.lights, model.name + "::" + link.name);
  return message;
}

visualization_msgs::msg::MarkerArray contact_markers(const std::vector<Contact>& contacts) {
  Marker places = contacts_marker(0, Marker::SPHERE_LIST, 0.02);
  Marker forces = contacts_marker(1, Marker::LINE_LIST, 0.006);
  for (const Contact& contact : contacts)
    for (const ContactPoint& one : contact.points) {
      if (places.points.size() == kMostContacts) break;
      places.points.push_back(point_message(one.position));
      const double newtons = length(one.wrench.force);
      if (newtons <= 0) continue;
      const double long_as = std::min(kMetresPerNewton * newtons, kLongestForce);
      forces.points.push_back(point_message(one.position));
      forces.points.push_back(point_message(one.position + (long_as / newtons) * one.wrench.force));
    }
  visualization_msgs::msg::MarkerArray message;
  message.markers = {std::move(places), std::move(forces)};
  return message;
}

SceneMarkers scene_markers(const World& world, SceneShapes shapes, const MeshReader& meshes) {
  Writer writer(meshes);
  for (const Model& model : world.models)
    for (const Link& link : model.links) {
      writer.begin_link(model.name + "::" + link.name, !model.is_static);
      if (shapes == SceneShapes::kCollisions) {
        for (const Collision& one : link.collisions)
          writer.add(one.name, one.pose, one.geometry, collision_color(one.geometry), false);
        continue;
      }
      for (const Visual& one : link.visuals) {
        Color color = one.material.diffuse;
        color.a *= 1 - one.transparency;
        writer.add(one.name, one.pose, one.geometry, color, !one.material.is_given);
      }
    }
  return writer.take();
}

}  // namespace ros2wasm_sim
