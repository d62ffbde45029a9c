// A heightmap: a grey picture whose brightness is a height.
#pragma once

#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"
#include "world/world.hpp"

namespace ros2wasm_sim {

constexpr int kMostHeights = 1025;  ///< along one side

/// The brightest pixel of the picture is 1 m high, black is 0. Nothing when the bytes are not a
/// picture, or when it has more than kMostHeights pixels along a side, or fewer than two.
std::optional<TriangleMesh> read_heights(const std::string& bytes);

/// A heightmap as a mesh, which MeshReader reads from the picture; it stands at `position` of the
/// heightmap.
Mesh mesh_of(const Heightmap& map);

}  // namespace ros2wasm_sim
