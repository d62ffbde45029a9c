// Containers of launch files, as a site has them: a program that is linked with the components of
// the packages, which are given to it at the start. Pure.
#pragma once

#include <optional>

#include "bundler/launch/launch_description.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct ContainerProcess {
  std::optional<LaunchProcess> process;  ///< none when no component is loaded into it
  Diagnostics warnings;                  ///< R2W0417
};

/// Whether it is a container that a launch file fills: one with components, or one of
/// rclcpp_components.
[[nodiscard]] bool is_container(const LaunchProcess& process);

/// Its program is that of the first component's package, linked with those of the others. R2W0417
/// when a program of the workspace's own is the container; errors of parameter files.
[[nodiscard]] Outcome<ContainerProcess> container_process(const LaunchProcess& container,
                                                          const ParameterFiles& parameter_files);

}  // namespace ros2wasm
