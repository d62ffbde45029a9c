// Meshes of files, for the physics.
#pragma once

#include <rclcpp/logger.hpp>

#include "physics/physics.hpp"

namespace ros2wasm_sim {

/// Reads files of the site, each once. Logs what cannot be read.
MeshReader site_meshes(const rclcpp::Logger& logger);

}  // namespace ros2wasm_sim
