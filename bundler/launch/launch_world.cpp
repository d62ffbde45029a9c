// See launch_world.hpp.
#include "bundler/launch/launch_world.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Where share/<package> is on this machine.
using ShareOf = std::function<std::optional<fs::path>(const std::string& package)>;

Diagnostic unreadable(const std::string& path, std::string why) {
  return {.code = "R2W0413", .message = "`" + path + "` cannot be read", .why = {std::move(why)}};
}

/// What a path of the site is on this machine: something in `root`, a folder of it.
struct Inside {
  fs::path root;
  fs::path below;
};

/// The real path, if it is there and no link leads out.
Outcome<fs::path> real_path(const Inside& place, const std::string& shown) {
  std::error_code error;
  const fs::path real_root = fs::canonical(place.root, error);
  const fs::path real = error ? fs::path() : fs::canonical(place.root / place.below, error);
  if (error) return unreadable(shown, "there is no such file");
  const fs::path inside = real.lexically_relative(real_root);
  if (inside.empty() || *inside.begin() == "..")
    return unreadable(shown, "it leads out of " + place.root.filename().string());
  return real;
}

Outcome<std::string> read_within(const Inside& place, const std::string& shown) {
  const auto real = real_path(place, shown);
  if (!real) return real.errors();
  auto text = read_file(*real);
  if (!text) return unreadable(shown, text.errors().front().message);
  return text;
}

std::vector<std::string> names_within(const Inside& place) {
  std::vector<std::string> names;
  const auto real = real_path(place, {});
  if (!real) return names;
  std::error_code error;
  for (fs::directory_iterator at(*real, error), end; !error && at != end; at.increment(error))
    names.push_back(at->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// A file of the workspace by its place there, one of a package as share/<package>/...
std::string shown_as(const std::string& path, const std::string& prefix) {
  const fs::path normal = fs::path(path).lexically_normal();
  for (const fs::path& root : {fs::path(kLaunchWorkspace), fs::path(prefix)}) {
    const fs::path below = normal.lexically_relative(root);
    if (!below.empty() && *below.begin() != "..") return below.generic_string();
  }
  return path;
}

LaunchWorld world_of(const fs::path& folder, const std::string& distro, ShareOf share_of,
                     std::function<bool(const std::string&)> exists) {
  const std::string prefix = "/opt/ros/" + distro;
  LaunchWorld world;
  world.environment = {{"AMENT_PREFIX_PATH", prefix},
                       {"HOME", "/home/user"},
                       {"ROS_DISTRO", distro},
                       {"ROS_VERSION", "2"}};
  world.prefix_of = [prefix, exists = std::move(exists)](
                        const std::string& package) -> std::optional<std::string> {
    return exists(package) ? std::optional(prefix) : std::nullopt;
  };
  world.shown = [prefix](const std::string& path) { return shown_as(path, prefix); };
  const auto place = [folder, prefix,
                      share_of = std::move(share_of)](const std::string& path) -> Outcome<Inside> {
    const fs::path normal = fs::path(path).lexically_normal();
    const fs::path in_workspace = normal.lexically_relative(kLaunchWorkspace);
    if (!in_workspace.empty() && *in_workspace.begin() != "..") return Inside{folder, in_workspace};
    const fs::path in_share = normal.lexically_relative(fs::path(prefix) / "share");
    if (in_share.empty() || *in_share.begin() == "..")
      return unreadable(path, "a site has the files of packages only, below " + prefix + "/share");
    const std::string package = in_share.begin()->string();
    const auto share = share_of(package);
    if (!share) return unreadable(path, "there is no package `" + package + "`");
    return Inside{*share, in_share.lexically_relative(package)};
  };
  world.read = [place](const std::string& path) -> Outcome<std::string> {
    const auto inside = place(path);
    if (!inside) return inside.errors();
    return read_within(*inside, path);
  };
  world.names_in = [place](const std::string& path) {
    const auto inside = place(path);
    return inside ? names_within(*inside) : std::vector<std::string>();
  };
  return world;
}

}  // namespace

LaunchWorld installed_launch_world(const fs::path& folder,
                                   const std::vector<InstalledPackage>& installed,
                                   const std::string& distro) {
  const auto share_of = [&installed](const std::string& name) -> std::optional<fs::path> {
    for (const InstalledPackage& one : installed)
      if (one.name == name) return one.prefix / "share" / name;
    return std::nullopt;
  };
  return world_of(folder, distro, share_of,
                  [share_of](const std::string& name) { return share_of(name).has_value(); });
}

LaunchWorld source_launch_world(const fs::path& folder, const std::vector<LocalPackage>& packages,
                                const std::string& distro) {
  const auto share_of = [&packages](const std::string& name) -> std::optional<fs::path> {
    for (const LocalPackage& one : packages)
      if (one.xml.name.value == name) return one.directory;
    return std::nullopt;
  };
  return world_of(folder, distro, share_of, [](const std::string&) { return true; });
}

}  // namespace ros2wasm
