// The triangles of a mesh file, with the colours that the file gives them.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace ros2wasm_sim {

/// Faces that look alike: from `first_face` to where the next part begins.
struct MeshPart {
  std::size_t first_face = 0;
  std::optional<Color> diffuse;
  std::string texture;  ///< the name of a picture, relative to the mesh; empty: none
};

/// A submesh: from `first_face` to where the next one begins.
struct MeshObject {
  std::size_t first_face = 0;
  std::string name;      ///< of the node, or of the object
  std::string geometry;  ///< its other name; may be empty
};

/// Three coordinates a vertex, three vertices a face.
struct TriangleMesh {
  std::vector<float> vertices;
  std::vector<int> faces;
  /// Two for each corner of each face, (0, 0) at the upper left of a picture; or empty.
  std::vector<float> uvs;
  std::vector<MeshPart> parts;  ///< empty: the file gives no colours
  std::vector<MeshObject> objects;
  /// For a heightmap, else 0: `columns * rows` vertices from north-west, row by row, in a square of
  /// 1 m around the origin, from 0 to 1 m high. The faces may be coarser than that.
  int columns = 0, rows = 0;
};
/// The same for meshes of the same file and part.
inline std::string part_key(const Mesh& mesh) {
  return mesh.path + "\n" + mesh.submesh + (mesh.center_submesh ? "\ncentered" : "");
}

using MeshReader = std::function<std::shared_ptr<const TriangleMesh>(const Mesh& mesh)>;

}  // namespace ros2wasm_sim
