// Worlds of SDF.
#pragma once

#include "sdf/xml_values.hpp"

namespace ros2wasm_sim {

/// Reads a <world>. With errors in the context the result is incomplete.
World read_world_element(Context& context, const Node& node);

}  // namespace ros2wasm_sim
