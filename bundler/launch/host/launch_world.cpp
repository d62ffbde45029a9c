// See launch_world.hpp.
#include "bundler/launch/host/launch_world.hpp"

#include <algorithm>
#include <utility>

#include "bundler/io/files.hpp"
#include "bundler/workspace/channel_request.hpp"
#include "bundler/workspace/python_tree.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// The place of a path of the site on this machine: `below` in the folder `root`.
struct Inside {
  fs::path root;
  fs::path below;
};

bool has_hidden_part(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) {
    const std::string name = part.string();
    return name.size() > 1 && name.starts_with('.') && name != "..";
  });
}

/// The real path, if it is there, no link leads out and nothing of it is hidden.
Outcome<fs::path> checked_path(const Inside& place, const std::string& shown) {
  std::error_code error;
  if (!fs::exists(place.root / place.below, error))
    return unreadable_launch_path(shown, kNoSuchLaunchFile);
  auto real = path_within(place.root, place.root / place.below);
  if (real && has_hidden_part(real->lexically_relative(fs::canonical(place.root, error))))
    return unreadable_launch_path(shown, "hidden files are not seen");
  if (real) return std::move(*real);
  return unreadable_launch_path(shown, "it leads out of " + place.root.filename().string());
}

Outcome<std::string> read_within(const Inside& place, const std::string& shown) {
  const auto real = checked_path(place, shown);
  if (!real) return real.errors();
  auto text = read_file(*real, kMostOfList);
  if (!text) return unreadable_launch_path(shown, text.errors().front().message);
  return text;
}

std::vector<std::string> names_within(const Inside& place) {
  std::vector<std::string> names;
  const auto real = checked_path(place, {});
  if (!real) return names;
  std::error_code error;
  for (fs::directory_iterator at(*real, error), end; !error && at != end; at.increment(error))
    if (!has_hidden_part(at->path().filename())) names.push_back(at->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The folder that a path is in, and the rest of the path.
std::optional<std::pair<const LaunchFolder*, fs::path>> found_in(
    const std::vector<LaunchFolder>& folders, const std::string& path) {
  const fs::path normal = fs::path(path).lexically_normal();
  for (const LaunchFolder& folder : folders) {
    const fs::path below = normal.lexically_relative(folder.at);
    if (!below.empty() && *below.begin() != "..") return std::pair(&folder, below);
  }
  return std::nullopt;
}

Outcome<Inside> place_in(const std::vector<LaunchFolder>& folders, const std::string& prefix,
                         const std::string& path) {
  if (auto found = found_in(folders, path))
    return Inside{found->first->from, std::move(found->second)};
  return no_launch_path(path, prefix);
}

}  // namespace

std::vector<LaunchFolder> installed_launch_folders(const fs::path& folder,
                                                   const std::vector<InstalledPackage>& installed,
                                                   const fs::path& environment,
                                                   const std::string& distro) {
  std::vector<LaunchFolder> result{{.at = kLaunchWorkspace, .from = folder}};
  std::error_code error;
  for (const InstalledPackage& one : installed) {
    result.push_back(
        {.at = launch_share(distro, one.name), .from = one.prefix / "share" / one.name});
    const fs::path modules = one.prefix / kPythonModules;
    if (one.prefix != environment && fs::is_directory(modules, error))
      result.push_back({.at = "/modules/" + one.name, .from = modules, .holds_modules = true});
  }
  return result;
}

std::vector<LaunchFolder> source_launch_folders(const fs::path& folder,
                                                const std::vector<LocalPackage>& packages,
                                                const std::string& distro) {
  std::vector<LaunchFolder> result{{.at = kLaunchWorkspace, .from = folder}};
  for (const LocalPackage& one : packages) {
    const std::string& name = one.xml.name.value;
    std::error_code error;
    // The module that ament_python_install_package() installs for a package that CMake builds.
    const bool has_module = fs::is_regular_file(one.directory / name / "__init__.py", error);
    result.push_back({.at = launch_share(distro, name),
                      .from = one.directory,
                      .holds_modules = has_module || one.xml.build_type == kPythonBuildType});
  }
  return result;
}

LaunchWorld launch_world(std::vector<LaunchFolder> folders, const std::string& distro,
                         bool is_built) {
  const std::string prefix = launch_prefix(distro);
  LaunchWorld world;
  world.environment = launch_environment(distro);
  world.prefix_of = [prefix, folders, distro,
                     is_built](const std::string& package) -> std::optional<std::string> {
    const bool has_files = std::any_of(
        folders.begin(), folders.end(),
        [&](const LaunchFolder& one) { return one.at == launch_share(distro, package); });
    return has_files || !is_built ? std::optional(prefix) : std::nullopt;
  };
  world.shown = [prefix](const std::string& path) { return shown_launch_path(path, prefix); };
  if (!is_built)
    world.is_later = [prefix](const std::string& path) {
      return fs::path(path).lexically_normal().string().starts_with(prefix + "/share/");
    };
  world.read = [folders, prefix](const std::string& path) -> Outcome<std::string> {
    const auto inside = place_in(folders, prefix, path);
    if (!inside) return inside.errors();
    return read_within(*inside, path);
  };
  world.names_in = [folders = std::move(folders), prefix](const std::string& path) {
    const auto inside = place_in(folders, prefix, path);
    return inside ? names_within(*inside) : std::vector<std::string>();
  };
  return world;
}

std::optional<fs::path> real_path(const std::vector<LaunchFolder>& folders,
                                  const std::string& path) {
  const auto found = found_in(folders, path);
  return found ? std::optional(found->first->from / found->second) : std::nullopt;
}

}  // namespace ros2wasm
