// See container_programs.hpp.
#include "bundler/container_programs.hpp"

#include <algorithm>

#include "bundler/build/container_link.hpp"

namespace ros2wasm {
namespace {

/// For launch arguments that are given when the site starts.
void add_program(const LaunchNode& node, const std::string& name, PackedLaunch& launch) {
  const auto package =
      std::find_if(launch.installed.begin(), launch.installed.end(),
                   [&](const InstalledPackage& one) { return one.name == node.package; });
  if (package == launch.installed.end()) return;
  const bool is_there =
      std::any_of(package->programs.begin(), package->programs.end(),
                  [&](const InstalledProgram& one) { return one.executable == name; });
  if (is_there) return;
  package->programs.push_back({.package = node.package,
                               .executable = name,
                               .file = node.program,
                               .kind = node.kind,
                               .left_out = {}});
}

}  // namespace

Outcome<Done> link_containers(const BuiltPackages& built, LaunchedFile& launched,
                              const Cancellation& cancellation, const ProgressSink& progress) {
  Diagnostics errors;
  for (auto* nodes : {&launched.nodes, &launched.more_nodes}) {
    for (LaunchNode& node : *nodes) {
      if (node.linked_with.empty()) continue;
      const std::string name = node.program.stem().string();
      std::vector<std::string> packages = {node.package};
      packages.insert(packages.end(), node.linked_with.begin(), node.linked_with.end());
      auto file = link_container(node.executable, name, packages, built.sources, built.packages,
                                 built.tools, built.settings, cancellation, progress);
      if (!file) {
        for (Diagnostic& one : std::move(file).errors()) {
          if (!one.span) one.span = node.source;
          errors.push_back(std::move(one));
        }
        continue;
      }
      node.program = std::move(*file);
      if (launched.launch) add_program(node, name, *launched.launch);
    }
  }
  if (!errors.empty()) return errors;
  return Done{};
}

}  // namespace ros2wasm
