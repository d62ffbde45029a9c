// Makes a site once more, out of what it carries, and compares: whether it is what its sources
// make.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/pipeline.hpp"
#include "bundler/verify/site_diff.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

struct RebuildRequest {
  std::filesystem::path site;       ///< a folder, or an archive that `pack -o NAME.zip` wrote
  std::filesystem::path workspace;  ///< in place of what the site carries; empty: that
  std::filesystem::path output;     ///< where the new site stays; empty: nowhere
  bool offline = false;             ///< nothing comes over the network
  unsigned jobs = 0;                ///< compilers at once; 0: one per processor
  std::string archive_limits;       ///< see extract_limits.hpp; empty: as the environment says
  std::filesystem::path executable;
  EnvironmentVariables variables;
};

struct RebuildReport {
  std::string sha256;                       ///< of the site
  std::string made;                         ///< of the one that its sources make
  std::string generator;                    ///< what packed the site
  std::vector<SiteDifference> differences;  ///< from the site to the new one; none: it is the same
  Diagnostics warnings;
  std::vector<std::string> remarks;
};

/// Programs are compiled, none is taken from an earlier build. R2W0650 and R2W0651 the site has not
/// the bytes that it lists, R2W0662 it carries no sources, what unpack_sources() and pack() say.
[[nodiscard]] Outcome<RebuildReport> rebuild(const RebuildRequest& request,
                                             const Cancellation& cancellation,
                                             const ProgressSink& progress);

}  // namespace ros2wasm
