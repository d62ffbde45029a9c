// Containers of launch files, as a site has them: each package of components has a container of its
// own, which is given its components at the start. Pure.
#pragma once

#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

struct ContainerProcesses {
  std::vector<LaunchProcess> processes;  ///< one for each package, in the order of the components
  Diagnostics warnings;                  ///< R2W0417
};

/// Whether it is a container that a launch file fills: one with components, or one of
/// rclcpp_components.
[[nodiscard]] bool is_container(const LaunchProcess& process);

/// The first process has the container's name, the others have their package's behind it. R2W0417
/// when a program of the workspace's own is the container; errors of parameter files.
[[nodiscard]] Outcome<ContainerProcesses> container_processes(
    const LaunchProcess& container, const ParameterFiles& parameter_files);

}  // namespace ros2wasm
