// See default_manifest.hpp.
#include "bundler/workspace/default_manifest.hpp"

namespace ros2wasm {
namespace {

/// A workspace name out of a folder's name: lower-case letters, digits and single underscores.
std::string workspace_name(const std::string& folder) {
  std::string name;
  for (const char c : folder) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool digit = c >= '0' && c <= '9';
    if (letter || (digit && !name.empty())) {
      name += (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (name.ends_with('_')) name.pop_back();
  return name.empty() ? "workspace" : name;
}

}  // namespace

Manifest default_manifest(const std::filesystem::path& folder) {
  Manifest manifest;
  manifest.file = folder.string();
  manifest.name.value = workspace_name(folder.filename().string());
  manifest.title = folder.filename().string();
  manifest.version = "0.0.0";
  manifest.packages.push_back({.value = ".", .span = {.file = folder.string(), .line_text = {}}});
  return manifest;
}

std::vector<NodeEntry> default_nodes(const std::vector<InstalledPackage>& local) {
  std::vector<NodeEntry> nodes;
  for (const InstalledPackage& package : local) {
    for (const InstalledProgram& program : package.programs) {
      if (program.kind == ProgramKind::kNone) continue;
      NodeEntry node;
      node.package.value = package.name;
      node.executable.value = program.executable;
      nodes.push_back(std::move(node));
    }
  }
  return nodes;
}

}  // namespace ros2wasm
