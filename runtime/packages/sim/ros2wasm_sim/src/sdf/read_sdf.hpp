// SDF 1.4 to 1.12: worlds and models.
#pragma once

#include <string>

#include "sdf/reading.hpp"

namespace ros2wasm_sim {

/// The text of a .world or .sdf file with a <world>. All mistakes are reported, not the first one.
Reading<World> read_world(const std::string& text, const std::string& file,
                          const Resources& resources);

/// The first <model> or <light> of a text: of the root, or of its <world>; or a URDF.
/// A light comes as a model of one link that has it.
Reading<Model> read_model(const std::string& text, const std::string& file,
                          const Resources& resources);

}  // namespace ros2wasm_sim
