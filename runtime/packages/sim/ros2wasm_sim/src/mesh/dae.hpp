// Triangles of COLLADA files (.dae).
#pragma once

#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace ros2wasm_sim {

/// All geometries where the file's scene has them, in metres by its unit; which axis it calls up
/// does not count, as in RViz; with the diffuse colours and pictures of its materials. Nothing when
/// the text is not a COLLADA file, or has more triangles than `most`.
std::optional<TriangleMesh> read_dae(const std::string& text, std::size_t most);

}  // namespace ros2wasm_sim
