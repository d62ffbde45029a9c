// Triangles of OBJ files.
#pragma once

#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace ros2wasm_sim {

/// The bytes of a file whose name is relative to the mesh, or nothing.
using ReadBeside = std::function<std::optional<std::string>(const std::string& name)>;

/// Nothing when the text is not an OBJ file, or has more triangles than `most`. Polygons become
/// fans of triangles. Colours come from the files that `mtllib` names.
std::optional<TriangleMesh> read_obj(const std::string& text, std::size_t most,
                                     const ReadBeside& beside = {});

}  // namespace ros2wasm_sim
