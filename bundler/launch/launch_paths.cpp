// See launch_paths.hpp.
#include "bundler/launch/launch_paths.hpp"

#include <filesystem>
#include <utility>

namespace ros2wasm {
namespace fs = std::filesystem;

std::string launch_prefix(const std::string& distro) {
  return "/opt/ros/" + distro;
}

std::string launch_share(const std::string& distro, const std::string& package) {
  return launch_prefix(distro) + "/share/" + package;
}

std::string shown_launch_path(const std::string& path, const std::string& prefix) {
  const fs::path normal = fs::path(path).lexically_normal();
  for (const fs::path& root : {fs::path(kLaunchWorkspace), fs::path(prefix)}) {
    const fs::path below = normal.lexically_relative(root);
    if (!below.empty() && *below.begin() != "..") return below.generic_string();
  }
  return path;
}

std::map<std::string, std::string> launch_environment(const std::string& distro) {
  return {{"AMENT_PREFIX_PATH", launch_prefix(distro)},
          {"HOME", "/home/user"},
          {"PWD", kLaunchWorkspace},
          {"ROS_DISTRO", distro},
          {"ROS_VERSION", "2"},
          {"USER", "user"}};
}

Diagnostic unreadable_launch_path(const std::string& path, std::string why) {
  return {.code = "R2W0413", .message = "`" + path + "` cannot be read", .why = {std::move(why)}};
}

Diagnostic no_launch_path(const std::string& path, const std::string& prefix) {
  const fs::path in_share = fs::path(path).lexically_normal().lexically_relative(prefix + "/share");
  if (in_share.empty() || *in_share.begin() == "..")
    return unreadable_launch_path(
        path, "a site has the files of packages only, below " + prefix + "/share");
  return unreadable_launch_path(
      path, "there are no files of package `" + in_share.begin()->string() + "`");
}

}  // namespace ros2wasm
