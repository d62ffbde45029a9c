// See pack_launch.hpp.
#include "bundler/pack_launch.hpp"

#include "bundler/carried_programs.hpp"
#include "bundler/container_programs.hpp"
#include "bundler/launch/host/parameter_sources.hpp"
#include "bundler/launch/launch_graph.hpp"
#include "bundler/workspace/default_manifest.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Nodes of the manifest, or every program of the workspace.
Outcome<LaunchedFile> launch_listed(const BuiltWorkspace& workspace, PackNotes& notes) {
  const BuiltPackages& built = workspace.built;
  const Manifest& manifest = workspace.read.manifest;
  std::vector<NodeEntry> entries = manifest.nodes;
  if (manifest.nodes.empty()) {
    const auto local_end =
        built.installed.begin() + static_cast<std::ptrdiff_t>(built.packages.size());
    entries = default_nodes({built.installed.begin(), local_end});
    if (entries.empty()) {
      return Diagnostic{.code = "R2W0406",
                        .message = "the workspace has no program to run",
                        .why = {"none of its packages installs an executable into lib/<package>/"}};
    }
    std::vector<std::string> names;
    for (const NodeEntry& node : entries)
      names.push_back(node.package.value + "/" + node.executable.value);
    notes.remarks.push_back("every program runs once: " + name_list(names, 12));
  }
  const fs::path& folder = workspace.read.folder;
  ParameterFiles files;
  Diagnostics errors = read_parameter_files(entries, folder, files);
  for (const NodeEntry& node : entries) {
    for (const auto& file : node.parameter_files) notes.watched.push_back(folder / file.value);
  }
  auto nodes = launch_nodes(entries, built.installed, files, built.left_out);
  if (!nodes) append(errors, nodes.errors());
  if (!errors.empty()) return errors;
  // The same site whatever folder the pack was started in.
  for (LaunchNode& node : *nodes) node.source.file = fs::path(node.source.file).filename().string();
  return LaunchedFile{.nodes = std::move(*nodes),
                      .steps = {},
                      .more_nodes = {},
                      .launch = std::nullopt,
                      .by_default = manifest.nodes.empty()};
}

}  // namespace

Outcome<LaunchedFile> launch(const PackRequest& request, const BuiltWorkspace& workspace,
                             PackNotes& notes, const Cancellation& cancellation,
                             const ProgressSink& progress) {
  const Manifest& manifest = workspace.read.manifest;
  auto launched = manifest.launch_file ? launch_from_file(request, workspace, notes, cancellation)
                                       : launch_listed(workspace, notes);
  if (!launched) {
    // A skipped package may be the reason, so report the warnings too.
    Diagnostics errors = std::move(launched).errors();
    append(errors, notes.warnings);
    return errors;
  }
  if (auto linked = link_containers(workspace.built, *launched, cancellation, progress); !linked)
    return std::move(linked).errors();
  if (auto carried = add_programs(manifest, workspace.built, *launched); !carried)
    return std::move(carried).errors();
  return launched;
}

}  // namespace ros2wasm
