// Programs of launch files that no site can start, by name, and their replacements. Pure.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "bundler/launch/launch_scope.hpp"

namespace ros2wasm {

/// Whether a site could have the package. One that it has is started, whatever its name.
using IsKnownPackage = std::function<bool(const std::string& package)>;

/// Whether something of the page stands in for the package's programs, or a site cannot run them.
[[nodiscard]] bool has_stand_in(const std::string& package, const IsKnownPackage& is_known);

/// A warning (R2W0415) each, or a note when the page shows all that the program would show. The
/// warning for rviz2 lists the displays of its configuration.
[[nodiscard]] Diagnostics left_out_of_site(const LaunchDescription& description,
                                           const IsKnownPackage& is_known,
                                           const LaunchWorld& world);

/// A panel of the page that does the work of a program, or a part of it.
struct StandInPanel {
  std::string panel;
  std::string file;  ///< of the site, that says what is shown; or none

  friend bool operator==(const StandInPanel&, const StandInPanel&) = default;
};

/// The 3D view for rviz2, with the file of `-d` when packages install it; Joints for
/// joint_state_publisher_gui; Simulation beside the simulator, and Teleop beside nodes of the
/// package joy. Each panel once.
[[nodiscard]] std::vector<StandInPanel> stand_in_panels(const LaunchDescription& description,
                                                        const IsKnownPackage& is_known);

/// These warnings as errors: of `--strict`.
[[nodiscard]] Diagnostics refused_when_strict(const Diagnostics& warnings);

}  // namespace ros2wasm
