// Finds mistakes that `ros2wasm pack` would refuse, without a compiler and without channels other
// than the one inside the program.
#pragma once

#include <filesystem>
#include <vector>

#include "bundler/build/compiler.hpp"
#include "bundler/workspace/discovery.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct CheckRequest {
  std::filesystem::path manifest;    ///< a file, named as messages shall name it
  std::filesystem::path executable;  ///< of this program
  EnvironmentVariables variables;
};

struct CheckReport {
  Manifest manifest;
  std::vector<LocalPackage> packages;
  std::vector<NodeEntry> launched;  ///< what the launch file starts, as far as a site can
  Diagnostics warnings;
};

/// Mistakes of the manifest first; then, all at once: launch files (R2W0410 to R2W0416), packages
/// (R2W0510 to R2W0512, package.xml), parameter files (R2W0403), channels' names (R2W0237,
/// R2W0240), and when all packages come from the workspace and the program, those that nobody has
/// (R2W0401, R2W0513).
[[nodiscard]] Outcome<CheckReport> check_workspace(const CheckRequest& request,
                                                   const Cancellation& cancellation);

}  // namespace ros2wasm
