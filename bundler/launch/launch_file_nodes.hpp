// The nodes that a launch file starts, as the site gets them. Pure but for what the world reads.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/launch_scope.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct LaunchFileNodes {
  std::vector<LaunchNode> nodes;
  std::vector<LaunchStep> steps;
  Diagnostics warnings;                   ///< R2W0412, R2W0415
  std::vector<StandInPanel> panels;       ///< that do the work of what is skipped
  std::vector<std::string> remarks;       ///< what the file logs
  std::vector<std::string> files;         ///< that were read, as launch files see them
  std::vector<LaunchArgument> arguments;  ///< that can be given, each once
};

/// `path`, `given` and `from` as evaluate_launch() takes them. What no site can start, such as
/// rviz2, is skipped with a warning (R2W0415). Errors of the launch files, and of nodes as in
/// launch_nodes().
[[nodiscard]] Outcome<LaunchFileNodes> launch_file_nodes(
    const std::string& path, const std::map<std::string, std::string>& given,
    const LaunchWorld& world, const std::vector<InstalledPackage>& installed,
    const SourceSpan& from, const LeftOutChains& left_out = {});

}  // namespace ros2wasm
