// The site before it exists: every file with its size, its SHA-256 and the reason it is there. Pure
// values.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/left_out.hpp"
#include "bundler/launch/packed_launch.hpp"
#include "bundler/launch/share_tree.hpp"
#include "bundler/plan/python_site.hpp"
#include "bundler/plan/site_component.hpp"
#include "bundler/plan/site_place.hpp"
#include "workspace_schema/manifest.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

struct PlannedFile {
  std::string path;  ///< relative to the site, with `/`
  std::string reason;
  std::string bytes;
  std::string sha256;
  Kept kept = Kept::kBeside;
  std::vector<FilePart> parts = {};  ///< when it does not lie in one piece
};

/// A file of the channel that lies beside the site. It is in no site.json: a visit never loads it.
struct ChannelFile {
  std::string path;  ///< relative to the site, with `/`
  std::string reason;
  std::string bytes;              ///< empty when it is a copy
  std::filesystem::path copy_of;  ///< an archive; empty when `bytes` has it
  std::uint64_t size = 0;
};

/// A node's program as the site has it.
struct PlannedNode {
  LaunchNode node;
  std::string program;  ///< path in the site
  std::string names;    ///< path in the site of its functions' names; empty when there are none
  bool threads = false;
  std::string script;                 ///< of a Python node: path in what is installed
  std::vector<std::string> archives;  ///< of a Python node: what it unpacks, in order
};

/// A launch file that is evaluated when the site starts.
struct PlannedLaunch {
  std::string data;                       ///< path in the site of what the evaluation needs
  std::string evaluator;                  ///< and of the program that does it
  std::vector<LaunchArgument> arguments;  ///< as they are without others being given
  bool asks_python = false;               ///< it, or what it includes, is written in Python
  std::vector<std::string> python;        ///< what runs it in the site, archives; empty: nothing
  std::vector<std::string> tried;  ///< arguments whose values Python was asked about for the site
};

struct PlannedNotebook {
  std::string file;                   ///< path in the site
  std::string program;                ///< as of a Python node
  std::vector<std::string> archives;  ///< as of a Python node
};

struct SitePlan {
  std::vector<PlannedFile> files;     ///< sorted by path; the last steps add site.json, SHA256SUMS
  std::string sha256;                 ///< of site.json, which has that of every file: of the site
  std::vector<PlannedNode> nodes;     ///< in launch order
  std::vector<PlannedNode> programs;  ///< that none of these runs; each once
  std::vector<LaunchStep> steps;      ///< of the launch file
  std::string launch_package;         ///< in which the manifest's launch file lies; or none
  std::vector<StandInPanel> panels;   ///< of the usual layout, for programs that are left out
  std::optional<PlannedNotebook> notebook;
  std::optional<PlannedLaunch> launch;  ///< when launch arguments can change what runs
  std::vector<std::string> packages;    ///< that the programs' index of packages has, sorted
  std::vector<PlannedSource> sources;   ///< Python files of the workspace
  std::vector<CheckEntry> checks;       ///< in the manifest's order, with ids of nodes
  std::vector<TaskEntry> tasks;         ///< the same
  std::vector<ChannelFile> channel;     ///< sorted by path; empty unless it was asked for
  std::string carried_page;             ///< the page of a site in one file, without the files
  SiteStore store = {};                 ///< that it shares with other sites
};

/// A file that the built runtime brings to every site.
struct RuntimeAsset {
  std::string file;
  std::string role;
  std::string bytes;
};

/// A file of the workspace that the page shows.
struct PageFile {
  std::string path;  ///< relative to the manifest, with `/`, within its folder
  std::string bytes;
};

/// Where the site has it: below `text/`.
[[nodiscard]] std::string page_text_path(const std::string& path);
/// The same for bags: below `bags/`.
[[nodiscard]] std::string page_bag_path(const std::string& path);

/// The page's notebook, whose kernel is a Python program.
struct NotebookInput {
  std::string file;                   ///< relative to the manifest
  std::vector<std::string> compiled;  ///< modules with compiled parts that its cells import
};

/// What the plan is made of.
struct PlanInput {
  const Manifest& manifest;
  std::vector<LaunchNode> nodes;
  std::vector<LaunchStep> steps;
  std::vector<LaunchNode> more_nodes;  ///< of programs that none of these runs
  std::optional<PackedLaunch> launch;
  std::string launch_package;        ///< in which the manifest's launch file lies; or none
  std::vector<StandInPanel> panels;  ///< of the usual layout
  std::map<std::filesystem::path, std::string> programs;  ///< bytes of each node's program file
  std::map<std::filesystem::path, std::string> names;     ///< by program file, where there are any
  std::vector<RuntimeAsset> runtime;
  InterfaceTexts interfaces;
  SharedFiles shared;                     ///< of all packages
  std::vector<std::string> packages;      ///< of the workspace
  PythonInput python;                     ///< empty without Python nodes
  std::vector<std::string> python_index;  ///< all packages that Python nodes can find
  std::vector<SiteComponent> components;  ///< what the site is made of
  std::vector<PageFile> text;             ///< Markdown and notebook of the page, their images
  std::vector<PageFile> bags;             ///< recordings that the page plays
  std::optional<NotebookInput> notebook;
  std::string sources = {};         ///< archive of what the site is made of; empty: it carries none
  std::uint64_t max_file_size = 0;  ///< larger ones lie in parts; 0: there is no ceiling
  std::string store = {};           ///< where the store lies that the site shares; see SiteStore
};

/// R2W0606 a program is not WebAssembly, R2W0430 a check names a node that is not there.
[[nodiscard]] Outcome<SitePlan> plan_site(PlanInput input);

/// The file of a site that lists its files, site.json too, for `sha256sum --check`.
inline constexpr const char* kHashList = "SHA256SUMS";
/// What the site is made of; see carried_sources.hpp.
inline constexpr const char* kSourcesArchive = "sources.zip";

inline constexpr const char* kHashListReason = "hashes of all files, for `sha256sum --check`";

/// Its text. `files` in their order there.
[[nodiscard]] std::string hash_list(const std::vector<PlannedFile>& files);

/// Relative to site.json, in the order of its parts.
[[nodiscard]] std::vector<std::string> places_of(const PlannedFile& file, const SitePlan& plan);

/// What lies where, with its sha256 and without its bytes, sorted.
[[nodiscard]] std::vector<PlannedFile> placed_files(const SitePlan& plan);

/// Total size of all files of the site in bytes.
[[nodiscard]] std::uint64_t total_size(const SitePlan& plan);

/// And of the channel beside it.
[[nodiscard]] std::uint64_t channel_size(const SitePlan& plan);

/// The part of it that a visit does not load: names of functions, for crash reports.
[[nodiscard]] std::uint64_t names_size(const SitePlan& plan);

}  // namespace ros2wasm
