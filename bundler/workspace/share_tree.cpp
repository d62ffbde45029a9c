// See share_tree.hpp.
#include "bundler/workspace/share_tree.hpp"

#include <algorithm>
#include <array>

#include "bundler/io/files.hpp"
#include "bundler/workspace/installed_tree.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// In share/<package>/, what the build and shells read: by folder and ending.
constexpr std::string_view kCmakeFolder = "cmake";
constexpr std::array<std::string_view, 2> kShellFolders = {"environment", "hook"};
/// Has a file of its own in the site.
constexpr std::array<std::string_view, 3> kInterfaceFolders = {"msg", "srv", "action"};
constexpr std::array<std::string_view, 4> kInterfaceEndings = {".msg", ".srv", ".action", ".idl"};
constexpr std::array<std::string_view, 3> kShellStems = {"local_setup", "package", "colcon"};
constexpr std::array<std::string_view, 6> kShellEndings = {".bash", ".dsv", ".ps1",
                                                           ".sh",   ".zsh", ".bat"};
/// Packages of these names, and resources of these kinds, generate code.
constexpr std::string_view kGenerators = "rosidl_";
/// In the index; of `packages` the loader makes the entries.
constexpr std::array<std::string_view, 3> kBuildResources = {"packages", "package_run_dependencies",
                                                             "parent_prefix_path"};
constexpr std::string_view kIndex = "share/ament_index/resource_index";

template <typename List>
bool has(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// `path`: below share/<package>/.
bool is_for_builds(const fs::path& path) {
  const std::string first = path.begin()->string();
  const std::string ending = path.extension().string();
  if (path.has_parent_path()) {
    return (first == kCmakeFolder && ending == ".cmake") ||
           (has(kShellFolders, first) && has(kShellEndings, ending)) ||
           (has(kInterfaceFolders, first) && has(kInterfaceEndings, ending));
  }
  return first == "package.xml" || first == "copyright" || sets_up_shell(path);
}

/// Launch files of Gazebo read in package.xml where the package has models, also in the site:
/// `<export><gazebo_ros gazebo_model_path="${prefix}/models"/></export>`.
bool has_paths_for_gazebo(const fs::path& prefix, const std::string& path) {
  if (!is_installed_file(prefix, path)) return false;
  const auto text = read_file(prefix / path, kMostOfList);
  return text && text->find("<gazebo_ros") != std::string::npos;
}

/// Host and browser read a backslash in an address as a slash.
bool has_address(const std::string& path) {
  return path.find('\\') == std::string::npos;
}

Outcome<Done> add_file(const fs::path& prefix, const std::string& path, SharedFiles& into,
                       std::vector<std::string>& left_out) {
  if (into.contains(path)) return Done{};
  if (!is_installed_file(prefix, path)) {
    left_out.push_back(path + kLeadsElsewhere);
    return Done{};
  }
  if (!has_address(path)) {
    left_out.push_back(path + ", whose name with a backslash is not an address");
    return Done{};
  }
  auto bytes = read_file(prefix / path, kMostOfData);
  if (!bytes) return std::move(bytes).errors();
  into.emplace(path, std::move(bytes).value());
  return Done{};
}

}  // namespace

bool sets_up_shell(const fs::path& name) {
  return has(kShellEndings, name.extension().string()) && has(kShellStems, name.stem().string());
}

Outcome<std::vector<std::string>> collect_shared_files(const fs::path& prefix,
                                                       const std::string& package,
                                                       SharedFiles& into) {
  std::vector<std::string> left_out;
  if (package.starts_with(kGenerators)) return left_out;
  const std::string share = "share/" + package;
  std::error_code error;
  if (fs::is_directory(prefix / share, error)) {
    const auto tree = list_tree(prefix / share);
    if (!tree) return tree.errors();
    for (const TreeEntry& entry : *tree) {
      const bool is_file = entry.kind == FileKind::kFile || entry.kind == FileKind::kLink;
      const bool is_description =
          entry.path == "package.xml" && has_paths_for_gazebo(prefix, share + "/package.xml");
      if (!is_file || (is_for_builds(entry.path) && !is_description)) continue;
      if (auto added = add_file(prefix, share + "/" + entry.path, into, left_out); !added)
        return std::move(added).errors();
    }
  }
  for (fs::directory_iterator it(prefix / kIndex, error), end; !error && it != end;
       it.increment(error)) {
    const std::string kind = it->path().filename().string();
    const std::string path = std::string(kIndex) + "/" + kind + "/" + package;
    if (has(kBuildResources, kind) || kind.starts_with(kGenerators) ||
        !fs::is_regular_file(prefix / path, error))
      continue;
    if (auto added = add_file(prefix, path, into, left_out); !added)
      return std::move(added).errors();
  }
  return left_out;
}

}  // namespace ros2wasm
