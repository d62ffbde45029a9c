// See workspace_lock.hpp.
#include "cli/workspace_lock.hpp"

#include <filesystem>

#include "bundler/resolve/locked_solve.hpp"
#include "workspace_schema/suggestion.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

Outcome<Lock> read_workspace_lock(const std::string& workspace) {
  std::error_code error;
  fs::path folder = workspace.empty() ? fs::path(".") : fs::path(workspace);
  if (fs::is_regular_file(folder, error)) folder = folder.parent_path();
  return read_lock_file((folder / kLockFileName).lexically_normal());
}

Diagnostic not_in_lock(const std::string& name, const Lock& lock) {
  Diagnostic made{.code = "R2W0331", .message = "the lock has no package `" + name + "`"};
  std::vector<std::string> names;
  for (const PackageRecord& record : lock.packages) names.push_back(record.name);
  if (const auto similar = nearest(name, names)) made.why.push_back("it has `" + *similar + "`");
  return made;
}

}  // namespace ros2wasm
