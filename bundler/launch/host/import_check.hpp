// Follows the imports of a Python program through the modules of the workspace: which modules are
// missing, and which compiled modules the program needs. Pure.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "bundler/workspace/python_tree.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {

/// Where modules can come from.
struct PythonWorld {
  const PythonFiles& workspace;
  const PythonFiles& channels;
  const PythonFiles& wheels;  ///< of the manifest; followed as the workspace's are
  const std::map<std::string, std::string>& interfaces;  ///< by type: "std_msgs/msg/String"
  const std::vector<std::string>& channel_names;         ///< of all packages there, sorted
  std::string distro;
  /// Projects of libraries that the site can have, by top-level module; their files are not
  /// followed.
  std::map<std::string, std::string> libraries = {};
  /// And of those that the workspace did not ask for, for messages.
  std::map<std::string, std::string> offered = {};
  bool takes_offered = true;  ///< the manifest does not leave them out
};

struct ImportReport {
  /// R2W0518: errors, and warnings for what a program can do without. R2W0526: warnings for what
  /// Python has and what does not work in a site. Files are named as they are installed.
  Diagnostics missing;
  std::set<std::string> own_files;  ///< of the workspace: what the program may import, and itself
  std::set<std::string> libraries;  ///< projects: what the program may import of them
  std::set<std::string> compiled;   ///< top-level modules with compiled parts, of the channels
};

/// Top-level modules of the channels that have compiled parts: "numpy".
[[nodiscard]] std::set<std::string> compiled_modules(const PythonFiles& channels);

/// `script`: path of the program, "lib/demo/talker". Of a channel's modules, what is missing is not
/// told.
[[nodiscard]] ImportReport check_imports(const std::string& script, const PythonWorld& world);

}  // namespace ros2wasm
