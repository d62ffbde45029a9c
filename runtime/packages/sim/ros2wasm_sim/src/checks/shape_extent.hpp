// How far shapes reach. Pure.
#pragma once

#include <optional>

#include "world/world.hpp"

namespace ros2wasm_sim {

/// Metres from the origin of a shape to its furthest point in a direction of length 1, both in the
/// frame that `orientation` turns the shape into. Nothing for planes, meshes and heightmaps.
std::optional<double> extent(const Geometry& geometry, const Quaternion& orientation,
                             const Vector3& direction);

}  // namespace ros2wasm_sim
