// A manifest for a folder that has none. Pure.
#pragma once

#include <string>
#include <vector>

#include "bundler/workspace/discovery.hpp"
#include "bundler/workspace/installed_tree.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// Named after the folder, with all packages below it. `folder` is an absolute path.
[[nodiscard]] Manifest default_manifest(const std::filesystem::path& folder);

/// One node for every program of the workspace's packages, in the order of packages and names.
[[nodiscard]] std::vector<NodeEntry> default_nodes(const std::vector<InstalledPackage>& local);

}  // namespace ros2wasm
