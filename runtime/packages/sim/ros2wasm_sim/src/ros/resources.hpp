// Files of the site that worlds and models name. Only this file and resources.cpp read the disk.
#pragma once

#include "physics/physics.hpp"
#include "sdf/reading.hpp"

namespace ros2wasm_sim {

/// Searches the folders of the environment's variables (GAZEBO_MODEL_PATH, GZ_SIM_RESOURCE_PATH and
/// their like), then the share folders of packages.
Resources site_resources();

/// A world by path or by bare name. Adds the folders that were searched.
std::optional<std::string> find_world(const std::string& name, std::vector<std::string>& searched);

/// Folders for a message, each once.
std::string listed(const std::vector<std::string>& folders);

}  // namespace ros2wasm_sim
