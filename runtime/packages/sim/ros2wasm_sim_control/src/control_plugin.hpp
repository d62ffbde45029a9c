// The plugins of Gazebo that run a controller manager in the simulator: gazebo_ros2_control,
// gz_ros2_control and ign_ros2_control.
#pragma once

#include <vector>

#include "plugins/table.hpp"

namespace ros2wasm_sim {

/// Their rows for the tables of both servers.
std::vector<PluginRow> control_plugins();

}  // namespace ros2wasm_sim
