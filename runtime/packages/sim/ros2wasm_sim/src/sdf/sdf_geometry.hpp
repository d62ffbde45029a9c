// Shapes of collisions and visuals, and how they touch.
#pragma once

#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

/// The shape in the <geometry> of an element. A shape that is not supported is a warning.
Geometry read_geometry(Context& context, const Node& parent);

/// Changes what a <surface> has of it.
void read_surface(Context& context, const Node& surface, Surface& value);

/// Finds the file of a mesh by its URI. Warns when it does not exist.
Mesh locate_mesh(Context& context, const Node& where, const std::string& uri);

}  // namespace ros2wasm_sim
