// Triangles of OBJ files.
#pragma once

#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace ros2wasm_sim {

/// Nothing when the text is not an OBJ file, or has more triangles than `most`. Polygons become
/// fans of triangles.
std::optional<TriangleMesh> read_obj(const std::string& text, std::size_t most);

}  // namespace ros2wasm_sim
