// The plan of a site: what its site.json and its page are rendered from. Pure values.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "bundler/site/site_file.hpp"
#include "bundler/site/site_place.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// A Python file of the workspace that the page shows, and of which visitors may try other texts.
struct PlannedSource {
  std::string path;  ///< in what is installed
  std::string file;  ///< in the workspace
  std::string sha256;
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
  std::string script;                  ///< of a Python node: path in what is installed
  std::vector<std::string> archives;   ///< of a Python node: what it unpacks, in order
  std::vector<std::string> load = {};  ///< and which compiled libraries of that it loads first
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
  std::string file;                    ///< path in the site
  std::string program;                 ///< as of a Python node
  std::vector<std::string> archives;   ///< as of a Python node
  std::vector<std::string> load = {};  ///< likewise
};

struct SitePlan {
  std::vector<PlannedFile> files;     ///< sorted by path; the last steps add site.json, SHA256SUMS
  std::string sha256;                 ///< of site.json, which has that of every file: of the site
  std::vector<PlannedNode> nodes;     ///< in launch order
  std::vector<PlannedNode> programs;  ///< that none of these runs; each once
  std::vector<LaunchStep> steps;      ///< of the launch file
  std::string launch_package;         ///< in which the manifest's launch file lies; or none
  std::vector<StandInPanel> panels;   ///< of the usual layout, for programs that are skipped
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

/// Relative to site.json, in the order of its parts.
[[nodiscard]] std::vector<std::string> places_of(const PlannedFile& file, const SitePlan& plan);

/// The files at their places, with sha256 and without bytes, sorted.
[[nodiscard]] std::vector<PlannedFile> placed_files(const SitePlan& plan);

/// Total size of all files of the site in bytes.
[[nodiscard]] std::uint64_t total_size(const SitePlan& plan);

/// And of the channel beside it.
[[nodiscard]] std::uint64_t channel_size(const SitePlan& plan);

/// The part of it that a visit does not load: names of functions, for crash reports.
[[nodiscard]] std::uint64_t names_size(const SitePlan& plan);

}  // namespace ros2wasm
