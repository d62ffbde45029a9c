// The triangles that a camera draws, in the frame of their shape.
#pragma once

#include <vector>

#include "physics/physics.hpp"
#include "world/world.hpp"

namespace ros2wasm_sim {

struct Corner {
  float position[3];  ///< metres
  float normal[3];    ///< of length 1
  float u, v;         ///< in a texture: (0, 0) is its upper left corner
};

/// Three corners a triangle.
using Triangles = std::vector<Corner>;

/// For shapes other than meshes; empty for NoGeometry, Mesh and Heightmap. Round ones have normals
/// of the true surface.
Triangles triangles_of(const Geometry& geometry);

/// For a part of a mesh: `first` and `count` faces. Faces that meet at less than 45 degrees look
/// round.
Triangles triangles_of(const TriangleMesh& mesh, const Vector3& scale, std::size_t first,
                       std::size_t count);

}  // namespace ros2wasm_sim
