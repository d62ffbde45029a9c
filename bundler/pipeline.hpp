// The whole way from a workspace to a site, in one place: pipeline.cpp reads as its table of
// contents.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/build_workspace.hpp"
#include "bundler/plan/plan_site.hpp"
#include "bundler/plan/site_signature.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/store/source_trees.hpp"
#include "bundler/store/wheel_files.hpp"
#include "bundler/workspace/page_notebook.hpp"
#include "bundler/workspace/python_libraries.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct PackRequest {
  std::string
      input;  ///< workspace.yaml, or a folder with or without one; empty: the current folder
  std::filesystem::path output;  ///< folder to write
  bool locked = false;           ///< fail rather than change ros2wasm.lock
  bool frozen = false;   ///< only the packages of ros2wasm.lock, which must fulfil what is asked
                         ///< (R2W0311); no channel is asked
  bool offline = false;  ///< nothing comes over the network
  bool with_channel = false;         ///< the packages of the channels lie beside the site
  bool plan_only = false;            ///< write nothing but the build cache
  bool plan_builds = false;          ///< of build(): it stops before something is built
  std::filesystem::path executable;  ///< of this program
  EnvironmentVariables variables;
  unsigned jobs = 0;            ///< compilers at once; 0: one per processor
  bool quick = false;           ///< larger programs, linked in a fraction of the time
  bool strict = false;          ///< what the launch file starts and no site can start is an error
  std::filesystem::path store;  ///< folder that sites share; empty: the site has all its files
  std::uint64_t max_file_size = 0;  ///< bytes; larger files are split into parts; 0: no limit
  bool precompress = false;         ///< a folder's files have compressed forms beside them
  std::filesystem::path built;      ///< where builds are kept; empty: in the cache
  std::string archive_limits;       ///< see extract_limits.hpp; empty: as the environment says
  LockUpdate update = {};           ///< what is chosen anew although the lock has it
  bool for_channel =
      false;  ///< packages that fail are listed, and no program is linked with plugins of others
  std::vector<NamedSource> more_sources = {};  ///< beside those of the manifest
  bool takes_carried = false;  ///< of a site that is made once more: the sources in it
  std::shared_ptr<const SiteSigner> signer;  ///< who signs the site; nobody when null
};

/// A workspace with all its packages built.
struct BuiltWorkspace {
  std::optional<PageNotebook> notebook;  ///< of the page
  Manifest manifest;
  bool has_manifest = true;
  bool nodes_by_default = false;           ///< the manifest names none, so all programs run
  std::vector<std::string> channel_names;  ///< of all packages there, sorted
  LeftOutChains left_out;                  ///< packages of the workspace that were not built
  std::filesystem::path folder;            ///< of the manifest, absolute
  std::filesystem::path shown_folder;      ///< the same as the person named it
  std::vector<SourceTree> source_trees;    ///< of `sources:` of the manifest
  std::vector<LocalPackage> sources;       ///< its packages, also those that were skipped
  BuildTools tools;                        ///< that built them,
  BuildSettings settings;                  ///< and how
  std::vector<BuiltPackage> packages;      ///< of the workspace, in build order
  std::vector<PlannedBuild> planned;       ///< when builds are only planned; nothing is built then
  std::vector<FailedPackage> failed;       ///< packages of the workspace, for a channel
  std::string client_abi;  ///< for a channel: the build of kClientAbi; empty when there is none
  std::vector<InstalledPackage>
      installed;                          ///< of workspace and channels; the workspace comes first
  std::filesystem::path environment;      ///< the prefix with the packages of the channels
  std::vector<NamedWheel> wheels;         ///< of the manifest, sorted by project
  std::vector<SiteComponent> components;  ///< those packages and the built ones, with licenses
  std::vector<ChannelFile> channel;       ///< what lies beside the site, if it was asked for
  std::vector<std::filesystem::path> watched;  ///< files and folders that a rebuild depends on
  std::filesystem::path cache;
  PythonLibraries offered;               ///< what Pyodide's distribution has
  std::vector<LockedLibrary> libraries;  ///< what the workspace asks of it, sorted by project
  std::string python_index;              ///< where their files come from
  ChannelRoots roots;                    ///< and how
  ExtractLimits limits;                  ///< of archives
  std::string lock_text;  ///< what ros2wasm.lock says, or would say if it were written
  Diagnostics warnings;
  std::vector<std::string> remarks;  ///< what was chosen and done, for people
};

struct PackReport {
  SitePlan plan;
  std::filesystem::path output;
  std::vector<std::filesystem::path> watched;
  Diagnostics warnings;
  std::vector<std::string> remarks;
};

struct LockRequest {
  std::string input;        ///< as in PackRequest
  bool check_only = false;  ///< write nothing, ask no channel: does the lock fulfil what is asked?
  LockUpdate update;        ///< what is chosen anew although the lock has it
  bool offline = false;     ///< as in PackRequest
  std::filesystem::path executable;
  EnvironmentVariables variables;
};

struct LockReport {
  std::filesystem::path file;
  std::vector<PackageRecord> packages;
  bool changed = false;
  Diagnostics warnings;
};

/// Writes ros2wasm.lock without building, or checks it by satisfiability (R2W0311, one per edge
/// that does not hold).
[[nodiscard]] Outcome<LockReport> lock(const LockRequest& request, const Cancellation& cancellation,
                                       const ProgressSink& progress);

/// Everything up to the installed packages.
[[nodiscard]] Outcome<BuiltWorkspace> build(const PackRequest& request,
                                            const Cancellation& cancellation,
                                            const ProgressSink& progress);

/// build(), then launch, plan, emit.
[[nodiscard]] Outcome<PackReport> pack(const PackRequest& request, const Cancellation& cancellation,
                                       const ProgressSink& progress);

}  // namespace ros2wasm
