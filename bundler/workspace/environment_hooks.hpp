// Environment hooks that packages install, such as one with the folder of their models for Gazebo:
// natively `source install/setup.bash` runs them.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bundler/workspace/installed_tree.hpp"

namespace ros2wasm {

/// An environment hook that a package installs.
struct EnvironmentHook {
  std::string text;
  bool is_list = true;  ///< `.dsv`, a list of its variables; else a shell script
};

/// Does a prefix have this path below it?
using HasPath = std::function<bool(const std::string& path)>;

/// Applies a hook. `prefix` is where the site has the package's files, such as /opt/ros/jazzy. The
/// variables that stand for folders of programs and libraries stay as they are. Pure but for `has`.
void apply_hook(const EnvironmentHook& hook, const std::string& prefix, const HasPath& has,
                std::map<std::string, std::string>& variables);

/// `variables`, with the hooks of all packages applied in their order. Reads
/// share/<package>/environment and hook.
[[nodiscard]] std::map<std::string, std::string> with_environment_hooks(
    std::map<std::string, std::string> variables, const std::vector<InstalledPackage>& packages,
    const std::string& prefix);

}  // namespace ros2wasm
