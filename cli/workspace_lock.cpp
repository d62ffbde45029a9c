// See workspace_lock.hpp.
#include "cli/workspace_lock.hpp"

#include <filesystem>

#include "bundler/resolve/locked_solve.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

Outcome<Lock> read_workspace_lock(const std::string& workspace) {
  std::error_code error;
  fs::path folder = workspace.empty() ? fs::path(".") : fs::path(workspace);
  if (fs::is_regular_file(folder, error)) folder = folder.parent_path();
  return read_lock_file((folder / kLockFileName).lexically_normal());
}

}  // namespace ros2wasm
