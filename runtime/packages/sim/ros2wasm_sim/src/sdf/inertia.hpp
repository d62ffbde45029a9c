// Masses with their moments: of shapes, and of several bodies that are one.
#pragma once

#include <optional>
#include <vector>

#include "world/world.hpp"

namespace ros2wasm_sim {

/// The sum of bodies in one frame, about their common centre of mass, along the axes of that frame.
/// A single body stays as it is.
Inertial combined(const std::vector<Inertial>& bodies);

/// The mass and moments of a solid shape around its own origin; nothing for planes and meshes.
std::optional<Inertial> solid(const Geometry& geometry, double density);

/// Whether a body can have these moments: all positive, and none greater than the sum of the
/// others.
bool is_possible(const Inertial& inertial);

}  // namespace ros2wasm_sim
