// The packages that a workspace requests from the channels. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/resolve/solve.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/skipped_packages.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// The build type of Python packages that have a setup.py.
inline constexpr std::string_view kPythonBuildType = "ament_python";

struct ChannelRequest {
  std::vector<RequestedSpec> specs;  ///< sorted by text, each once
  std::vector<std::string> absent;   ///< what packages that are skipped lack, sorted
  Diagnostics warnings;              ///< wished for at run time, but in no channel
};

/// `notebook_modules`: what the code of the page's notebook imports; its packages are asked for.
/// Dependencies of the manifest may be ROS package names; nodes may name packages that nobody
/// lists; packages that are skipped ask for nothing. R2W0513 for everything that no channel has;
/// against a lock, what it lacks is asked for all the same.
[[nodiscard]] Outcome<ChannelRequest> channel_request(
    const Manifest& manifest, const std::vector<LocalPackage>& packages,
    const LeftOutPackages& left_out, const KnownNames& known, const std::string& compiler_version,
    const std::vector<Spanned<std::string>>& notebook_modules = {});

/// The packages that a package uses and its package.xml does not name, as far as a channel has it:
/// what its CMakeLists.txt, Python imports and launch files ask for.
[[nodiscard]] std::vector<Spanned<std::string>> unnamed_needs(
    const LocalPackage& package, const std::vector<LocalPackage>& packages, const KnownNames& known,
    std::string_view distro);

/// A manifest's dependency as a match spec: conda names stay, ROS names get `ros-<distro>-`.
[[nodiscard]] std::string dependency_spec(const std::string& text, std::string_view distro,
                                          const std::vector<std::string>& channel_names);

}  // namespace ros2wasm
