// The values that the steps of a pack return, one for each, and the notes that all of them add to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/build_workspace.hpp"
#include "bundler/plan/plan_site.hpp"
#include "bundler/store/source_trees.hpp"
#include "bundler/store/wheel_files.hpp"
#include "bundler/workspace/page_notebook.hpp"
#include "bundler/workspace/python_libraries.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// Only the pipeline's steps add to them, and none of them reads them.
struct PackNotes {
  Diagnostics warnings;
  std::vector<std::string> remarks;            ///< what was chosen and done, for people
  std::vector<std::filesystem::path> watched;  ///< files and folders that a rebuild depends on
};

/// Step 1: the manifest, and what it names for the page.
struct ReadWorkspace {
  Manifest manifest;
  bool has_manifest = true;
  std::filesystem::path folder;          ///< of the manifest, absolute
  std::filesystem::path shown_folder;    ///< the same as the person named it
  std::optional<PageNotebook> notebook;  ///< of the page
};

/// Python libraries of Pyodide's distribution.
struct LibrarySupply {
  PythonLibraries offered;           ///< what the distribution has
  std::vector<LockedLibrary> asked;  ///< what the workspace asks of it, sorted by project
  std::string index;                 ///< where their files come from; empty when none is asked
};

/// Steps 2 and 3: where packages, wheels and libraries come from.
struct Supplies {
  ChannelRoots roots;
  ExtractLimits limits;                    ///< of archives
  std::vector<std::string> channel_names;  ///< of all packages there, sorted
  std::string client_abi;  ///< for a channel: the build of kClientAbi; empty when there is none
  std::vector<SourceTree> source_trees;  ///< of `sources:` of the manifest
  std::vector<NamedWheel> wheels;        ///< of the manifest, sorted by project
  LibrarySupply python;
};

/// Step 3: the packages of the channels, in one prefix.
struct FetchedPackages {
  std::vector<PackageRecord> records;
  std::string lock_text;  ///< what ros2wasm.lock says, or would say if it were written
  std::filesystem::path prefix;
  std::string key;                   ///< of all that is in the prefix
  std::vector<ChannelFile> channel;  ///< what lies beside the site, if it was asked for
};

/// Steps 4 to 6: the packages of the workspace as they were built, and what is installed then.
struct BuiltPackages {
  std::vector<LocalPackage> sources;   ///< also those that were skipped
  LeftOutChains left_out;              ///< that were not built
  BuildTools tools;                    ///< that built them,
  BuildSettings settings;              ///< and how
  std::vector<BuiltPackage> packages;  ///< in build order
  std::vector<PlannedBuild> planned;   ///< when builds are only planned; nothing is built then
  std::vector<FailedPackage> failed;   ///< for a channel
  std::vector<InstalledPackage>
      installed;                          ///< of workspace and channels; the workspace comes first
  std::vector<SiteComponent> components;  ///< those packages and the built ones, with licenses
};

/// A workspace with all its packages built.
struct BuiltWorkspace {
  ReadWorkspace read;
  Supplies supplies;
  FetchedPackages fetched;
  BuiltPackages built;
  PackNotes notes;
};

}  // namespace ros2wasm
