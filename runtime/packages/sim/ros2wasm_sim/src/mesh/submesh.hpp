// One object of a mesh file.
#pragma once

#include <optional>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace ros2wasm_sim {

/// The faces of the objects with that name, with their vertices only. `center` moves the middle of
/// their bounding box to the origin. Nothing when the file has no such object.
std::optional<TriangleMesh> submesh_of(const TriangleMesh& mesh, const std::string& name,
                                       bool center);

/// The names of all objects, each once, for messages.
std::string object_names(const TriangleMesh& mesh);

}  // namespace ros2wasm_sim
