// Contact sensors name collisions, whose names change when fixed joints are lumped.
#pragma once

#include <string>
#include <unordered_map>

#include "sdf/context.hpp"

namespace ros2wasm_sim {

/// Gives a contact sensor new XML when it names one of the collisions that were renamed.
void rename_contacts(Context& context, const std::unordered_map<std::string, std::string>& renamed,
                     Sensor& sensor);

}  // namespace ros2wasm_sim
