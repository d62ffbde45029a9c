// See workspace_lock.hpp.
#include "cli/workspace_lock.hpp"

#include <filesystem>

#include "bundler/resolve/locked_solve.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kShownDigits = 10;  // of a commit

}  // namespace

Outcome<Lock> read_workspace_lock(const std::string& workspace) {
  std::error_code error;
  fs::path folder = workspace.empty() ? fs::path(".") : fs::path(workspace);
  if (fs::is_regular_file(folder, error)) folder = folder.parent_path();
  return read_lock_file((folder / kLockFileName).lexically_normal());
}

const LockedSource* source_of_package(const Lock& lock, const std::string& package) {
  for (const LockedSource& source : lock.sources) {
    for (const std::string& one : source.packages)
      if (one.substr(0, one.find(' ')) == package) return &source;
  }
  return nullptr;
}

std::string title_of(const LockedSource& source) {
  if (source.git.empty()) return source.archive;
  const std::string revision = source.revision.empty() ? "" : " " + source.revision;
  return source.git + revision + ", commit " + source.commit.substr(0, kShownDigits);
}

void write_source(JsonWriter& json, const LockedSource& source) {
  json.begin_object();
  if (source.git.empty()) {
    json.field("archive", source.archive).field("sha256", source.sha256);
    if (!source.model.empty()) json.field("model", source.model);
  } else {
    json.field("git", source.git).field("revision", source.revision);
    json.field("commit", source.commit);
  }
  json.key("packages").begin_array();
  for (const std::string& one : source.packages) {
    const std::size_t space = one.find(' ');
    json.begin_object().field("name", one.substr(0, space));
    json.field("version", space == std::string::npos ? "" : one.substr(space + 1)).end_object();
  }
  json.end_array().end_object();
}

}  // namespace ros2wasm
