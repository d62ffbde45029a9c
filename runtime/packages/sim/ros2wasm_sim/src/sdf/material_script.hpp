// Materials of Gazebo Classic: scripts of its renderer, in files that end with `.material`. Pure.
#pragma once

#include <optional>
#include <string>

#include "world/world.hpp"

namespace ros2wasm_sim {

/// The part of one that a camera can show.
struct ScriptMaterial {
  Color ambient{1, 1, 1, 1};
  Color diffuse{1, 1, 1, 1};
  Color emissive{0, 0, 0, 1};
  std::string texture;  ///< the name of a picture; empty: none
};

/// The material of this name in the text of a script, or nothing. The first pass of its first
/// technique counts.
std::optional<ScriptMaterial> find_material(const std::string& script, const std::string& name);

}  // namespace ros2wasm_sim
