// Triangles of STL files, in text or binary.
#pragma once

#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace ros2wasm_sim {

/// Nothing when the bytes are not an STL file, or have more triangles than `most`.
std::optional<TriangleMesh> read_stl(const std::string& bytes, std::size_t most);

}  // namespace ros2wasm_sim
