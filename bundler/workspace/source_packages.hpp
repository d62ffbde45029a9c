// Which packages of the sources of a manifest a workspace takes. An edge: it reads their folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/store/source_trees.hpp"
#include "bundler/workspace/discovery.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct SourcePackages {
  std::vector<LocalPackage> packages;  ///< sorted by source and folder
  std::vector<std::string> remarks;    ///< what came from where, for people
};

/// The packages that the sources' entries name, or all of a source whose entry names none, and what
/// these need of the sources; a package of the workspace takes the place of one with its name, and
/// what it needs comes instead.
/// `shown_base` is how the person named the workspace's folder. R2W0255 a package that no source
/// has, or a source without any; R2W0254 files of Git LFS that are not there; those of
/// discover_packages().
[[nodiscard]] Outcome<SourcePackages> choose_source_packages(
    const std::vector<SourceTree>& trees, const std::vector<LocalPackage>& workspace,
    const std::filesystem::path& shown_base, const ConditionVariables& variables);

}  // namespace ros2wasm
