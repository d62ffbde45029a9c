// See carried_programs.hpp.
#include "bundler/carried_programs.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// As nodes without arguments; of a package without `executable` one for each program.
std::vector<NodeEntry> entries_of(const ProgramEntry& program,
                                  const std::vector<InstalledPackage>& installed) {
  NodeEntry entry;
  entry.span = program.span;
  entry.package = program.package;
  if (program.executable) {
    entry.executable = *program.executable;
    return {entry};
  }
  const auto package =
      std::find_if(installed.begin(), installed.end(),
                   [&](const InstalledPackage& one) { return one.name == program.package.value; });
  // Nobody has the package: the node says so.
  if (package == installed.end()) return {entry};
  std::vector<NodeEntry> entries;
  for (const InstalledProgram& one : package->programs) {
    if (one.kind == ProgramKind::kNone) continue;
    entry.executable = {.value = one.executable, .span = program.package.span};
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace

Outcome<Done> add_programs(const Manifest& manifest, const BuiltPackages& built,
                           LaunchedFile& launched) {
  std::set<fs::path> known;
  for (const LaunchNode& node : launched.nodes) known.insert(node.program);
  for (const LaunchNode& node : launched.more_nodes) known.insert(node.program);
  Diagnostics errors;
  for (const ProgramEntry& program : manifest.programs) {
    const std::vector<NodeEntry> entries = entries_of(program, built.installed);
    if (entries.empty()) {
      errors.push_back(Diagnostic{
          .code = "R2W0402",
          .message = "package `" + program.package.value + "` has no programs that a site can run",
          .span = program.package.span});
      continue;
    }
    auto nodes = launch_nodes(entries, built.installed, {}, built.left_out);
    if (!nodes) {
      for (Diagnostic& error : std::move(nodes).errors()) errors.push_back(std::move(error));
      continue;
    }
    for (LaunchNode& node : *nodes)
      if (known.insert(node.program).second) launched.more_nodes.push_back(std::move(node));
  }
  if (!errors.empty()) return errors;
  return Done{};
}

}  // namespace ros2wasm
