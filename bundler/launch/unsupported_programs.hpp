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

/// The replacement for the package's programs in a site: a view of the page for rviz2; nothing for
/// packages whose programs a site can run.
[[nodiscard]] std::optional<std::string> stand_in(const std::string& package,
                                                  const IsKnownPackage& is_known);

/// A warning (R2W0415) each. The warning for rviz2 lists the displays of its configuration, when
/// `world` has it.
[[nodiscard]] Diagnostics left_out_of_site(const LaunchDescription& description,
                                           const IsKnownPackage& is_known,
                                           const LaunchWorld& world);

/// A panel of the page that does the work of a program which is skipped.
struct StandInPanel {
  std::string panel;
  std::string file;  ///< of the site, that says what is shown; or none

  friend bool operator==(const StandInPanel&, const StandInPanel&) = default;
};

/// The 3D view for rviz2, with the file of `-d` when packages install it; Joints for
/// joint_state_publisher_gui; the 3D view for the simulator, too. Each panel once.
[[nodiscard]] std::vector<StandInPanel> stand_in_panels(const LaunchDescription& description,
                                                        const IsKnownPackage& is_known);

/// These warnings as errors: of `--strict`.
[[nodiscard]] Diagnostics refused_when_strict(const Diagnostics& warnings);

}  // namespace ros2wasm
