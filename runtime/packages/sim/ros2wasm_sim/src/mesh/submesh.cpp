// See submesh.hpp.
#include "mesh/submesh.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace ros2wasm_sim {
namespace {

void move_to_middle(TriangleMesh& mesh) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (std::size_t i = axis; i < mesh.vertices.size(); i += 3) {
      low = std::min(low, mesh.vertices[i]);
      high = std::max(high, mesh.vertices[i]);
    }
    for (std::size_t i = axis; i < mesh.vertices.size(); i += 3)
      mesh.vertices[i] -= (low + high) / 2;
  }
}

/// Copies faces of another mesh, and what they need.
class Copier {
 public:
  explicit Copier(const TriangleMesh& from)
      : from_(from), vertices_(from.vertices.size() / 3, -1) {}

  void copy(std::size_t first, std::size_t end) {
    begin_part(first);
    for (std::size_t face = first; face < end; ++face) {
      if (next_part_ < from_.parts.size() && from_.parts[next_part_].first_face == face)
        begin_part(face);
      for (std::size_t corner = 3 * face; corner < 3 * face + 3; ++corner) copy_corner(corner);
    }
  }

  TriangleMesh take() { return std::move(mesh_); }

 private:
  void begin_part(std::size_t face) {
    const auto next =
        std::upper_bound(from_.parts.begin(), from_.parts.end(), face,
                         [](std::size_t at, const MeshPart& part) { return at < part.first_face; });
    next_part_ = static_cast<std::size_t>(next - from_.parts.begin());
    if (next == from_.parts.begin()) return;  // the file gives no colours
    MeshPart part = *(next - 1);
    part.first_face = mesh_.faces.size() / 3;
    mesh_.parts.push_back(std::move(part));
  }

  void copy_corner(std::size_t corner) {
    int& vertex = vertices_[static_cast<std::size_t>(from_.faces[corner])];
    if (vertex < 0) {
      vertex = static_cast<int>(mesh_.vertices.size() / 3);
      const auto* at = &from_.vertices[3 * static_cast<std::size_t>(from_.faces[corner])];
      mesh_.vertices.insert(mesh_.vertices.end(), at, at + 3);
    }
    mesh_.faces.push_back(vertex);
    if (!from_.uvs.empty())
      mesh_.uvs.insert(mesh_.uvs.end(), {from_.uvs[2 * corner], from_.uvs[2 * corner + 1]});
  }

  const TriangleMesh& from_;
  std::vector<int> vertices_;  ///< the number in the copy; -1: it is not there yet
  std::size_t next_part_ = 0;
  TriangleMesh mesh_;
};

}  // namespace

std::optional<TriangleMesh> submesh_of(const TriangleMesh& mesh, const std::string& name,
                                       bool center) {
  const auto has = [&](std::string MeshObject::*which) {
    return std::any_of(mesh.objects.begin(), mesh.objects.end(),
                       [&](const MeshObject& one) { return one.*which == name; });
  };
  std::string MeshObject::*const which =
      has(&MeshObject::name) ? &MeshObject::name : &MeshObject::geometry;
  Copier copier(mesh);
  for (std::size_t i = 0; i < mesh.objects.size(); ++i) {
    const bool is_last = i + 1 == mesh.objects.size();
    const std::size_t end = is_last ? mesh.faces.size() / 3 : mesh.objects[i + 1].first_face;
    if (mesh.objects[i].*which == name) copier.copy(mesh.objects[i].first_face, end);
  }
  TriangleMesh result = copier.take();
  if (result.faces.empty()) return std::nullopt;
  if (center) move_to_middle(result);
  return result;
}

std::string object_names(const TriangleMesh& mesh) {
  std::set<std::string> names;
  for (const MeshObject& one : mesh.objects)
    for (const std::string& name : {one.name, one.geometry})
      if (!name.empty()) names.insert(name);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

}  // namespace ros2wasm_sim
