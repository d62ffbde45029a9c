// Builds the packages of a workspace in order, each into a prefix of its own that is named by the
// hash of all it depends on. A package whose hash is known is not built again, and no tool is
// started for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/build_package.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/skipped_packages.hpp"

namespace ros2wasm {

struct BuildSettings {
  std::filesystem::path cache;               ///< folder for results and work in progress
  std::filesystem::path environment_prefix;  ///< packages of the channels; may be empty
  std::string environment_key;               ///< changes with those packages
  std::vector<std::string>
      channel_packages;             ///< ROS names that the channels have, sorted: for advice
  Lacks lacks = {};                 ///< of packages that are built all the same
  BuilderOf* builder_of = nullptr;  ///< has a row for each build type of the order
  bool keeps_going = false;         ///< packages that fail are listed, not an error
};

struct BuiltPackage {
  std::string name;
  std::string version;
  std::filesystem::path prefix;
  std::string hash;
  bool from_cache = false;
  Diagnostics warnings = {};  ///< programs that were skipped, and what the compiler warned of
};

struct FailedPackage {
  std::string name;
  Diagnostics errors;
};

struct WorkspaceBuild {
  std::vector<BuiltPackage> packages;  ///< in build order, only what was built
  Diagnostics warnings;                ///< packages and programs that were skipped
  LeftOutChains left_out;              ///< the same, for who needs them
  std::vector<FailedPackage> failed;   ///< only when it keeps going
};

/// The first message of a failed build when the disk of `cache` has little room: the tools' own
/// messages seldom name the cause, and a linker without room dies like one with a bug. R2W0640.
[[nodiscard]] std::optional<Diagnostic> little_room(const std::filesystem::path& cache,
                                                    std::uint64_t available);

/// Tools are asked for only when something must be built, so a warm pack works without a compiler's
/// start. R2W0501 to R2W0508 as the steps say. `left_out` is not built (R2W0514, R2W0519:
/// warnings); nor is a package, nor those that need it, whose CMakeLists.txt asks for what nobody
/// has, when others are built (R2W0519, else what it lacks: R2W0513); nor are programs that include
/// a header that nobody has (R2W0522), or ask for what no browser has (R2W0523). R2W0640 before the
/// others when the disk is full. A package that fails does not stop those that do not need it: all
/// mistakes come at once. When it keeps going, those that need a package that failed are skipped
/// (R2W0514).
[[nodiscard]] Outcome<WorkspaceBuild> build_workspace(
    const std::vector<LocalPackage>& packages, const BuildOrder& order,
    const LeftOutPackages& left_out, const BuildTools& tools, const BuildSettings& settings,
    const Cancellation& cancellation, const ProgressSink& progress);

/// A package as a build of the workspace would treat it.
struct PlannedBuild {
  std::string name;
  std::string version;
  std::string origin;      ///< address and commit; empty: a folder of the user's
  bool is_cached = false;  ///< nothing is compiled
  double seconds =
      0;  ///< how long it takes, roughly: by earlier builds, else by the number of its sources
};

/// In build order; packages in `left_out` are absent. Nothing is built. R2W0210.
[[nodiscard]] Outcome<std::vector<PlannedBuild>> plan_builds(
    const std::vector<LocalPackage>& packages, const BuildOrder& order,
    const LeftOutPackages& left_out, const BuildTools& tools, const BuildSettings& settings);

/// Which of them were built, and which the cache had, in one line.
[[nodiscard]] std::string build_remark(const std::vector<BuiltPackage>& packages);

/// How much the compiler warned of, by package, in one line; empty when of nothing.
[[nodiscard]] std::string warnings_remark(const std::vector<BuiltPackage>& packages);

}  // namespace ros2wasm
