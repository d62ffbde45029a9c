// Step 7 of a pack with a launch file: what it starts, and what it starts with other launch
// arguments. An edge: reads files, runs Python.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/packed_launch.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "bundler/pack_values.hpp"
#include "bundler/request.hpp"

namespace ros2wasm {

/// Step 7: what runs.
struct LaunchedFile {
  std::vector<LaunchNode> nodes;
  std::vector<LaunchStep> steps;
  std::vector<LaunchNode>
      more_nodes;  ///< one for each program that nothing, or only other arguments, start
  std::optional<PackedLaunch> launch;  ///< when the launch file declares arguments
  std::string package = {};            ///< of the workspace, in which the launch file lies; or none
  std::vector<StandInPanel> panels = {};  ///< that do the work of what is skipped
  bool by_default = false;                ///< the manifest names no nodes, so all programs run
};

/// The nodes of the manifest's launch file with the launch arguments that it gives (R2W0730). What
/// else they can start is found by trying their choices, and true and false, 32 times at most;
/// faults there are warnings (R2W0440).
[[nodiscard]] Outcome<LaunchedFile> launch_from_file(const PackRequest& request,
                                                     const BuiltWorkspace& workspace,
                                                     PackNotes& notes,
                                                     const Cancellation& cancellation);

/// The same for one evaluation of any launch file, without programs: what a site would have of it.
/// Errors of the launch file.
[[nodiscard]] Outcome<PackedLaunch> packed_launch(const std::string& path,
                                                  const std::map<std::string, std::string>& given,
                                                  const LaunchWorld& world,
                                                  const std::vector<InstalledPackage>& installed,
                                                  const std::string& distro);

}  // namespace ros2wasm
