// The step that every command shares which reads the packages of a workspace: those of its
// `sources:`. Reads the lock, the disk and, unless it is offline, the network.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/resolve/locked_solve.hpp"
#include "bundler/store/source_trees.hpp"
#include "bundler/workspace/discovery.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct SourcesRequest {
  std::filesystem::path folder;        ///< of the manifest, absolute
  std::filesystem::path shown_folder;  ///< the same as the person named it
  LockUpdate update = {};              ///< what is chosen anew although the lock has it
  bool must_be_locked = false;         ///< a source that the lock does not have is an error
  bool takes_carried = false;          ///< as in SourceTreesRequest
};

struct WorkspaceSources {
  std::vector<SourceTree> trees;
  std::vector<std::filesystem::path> watched;  ///< files and folders of the user
  std::vector<std::string> remarks;            ///< for people
};

/// Fetches the sources of the manifest and adds the packages that are taken of them. Errors are
/// those of bring_source_trees(), choose_source_packages() and of the lock.
[[nodiscard]] Outcome<WorkspaceSources> add_source_packages(
    const Manifest& manifest, const SourcesRequest& request, const ChannelRoots& roots,
    const ExtractLimits& limits, std::vector<LocalPackage>& packages,
    const Cancellation& cancellation, const ProgressSink& progress);

/// The sources in the lock, without those that the request updates. Empty when there is no lock.
[[nodiscard]] Outcome<std::vector<LockedSource>> locked_sources(const SourcesRequest& request);

/// As they go into the lock: each once, sorted, with those of the packages that are taken of it.
[[nodiscard]] std::vector<LockedSource> sources_to_lock(const std::vector<SourceTree>& trees,
                                                        const std::vector<LocalPackage>& packages);

/// The same without the names of sources: what is left are packages of channels.
[[nodiscard]] LockUpdate without_sources(LockUpdate update, const std::vector<SourceTree>& trees);

}  // namespace ros2wasm
