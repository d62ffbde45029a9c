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

/// Three coordinates a vertex, three vertices a face.
struct TriangleMesh {
  std::vector<float> vertices;
  std::vector<int> faces;
  /// Two for each corner of each face, (0, 0) at the upper left of a picture; or empty.
  std::vector<float> uvs;
  std::vector<MeshPart> parts;  ///< empty: the file gives no colours
};
using MeshReader = std::function<std::shared_ptr<const TriangleMesh>(const Mesh& mesh)>;

}  // namespace ros2wasm_sim
