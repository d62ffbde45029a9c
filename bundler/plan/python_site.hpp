// The files that Python nodes need in a site: Pyodide, and archives of what is installed. Pure.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "bundler/launch/python_tree.hpp"
#include "bundler/launch/share_tree.hpp"

namespace ros2wasm {

/// Interface definitions by type: "std_msgs/msg/String" -> text.
using InterfaceTexts = std::map<std::string, std::string>;

/// Pyodide's wasm file in a site: the program of every Python node.
inline constexpr const char* kPythonProgram = "pyodide/pyodide.asm.wasm";

/// What Python nodes find installed.
struct PythonInput {
  PythonFiles pyodide;    ///< by name
  PythonFiles channels;   ///< modules and scripts of the packages of channels
  PythonFiles wheels;     ///< of the manifest
  PythonFiles workspace;  ///< and of the workspace's
  /// What of the latter the workspace has: path as installed -> path in the workspace.
  std::map<std::string, std::string> sources;
};

struct PythonSiteFile {
  std::string path;
  std::string reason;
  std::string bytes;
};

/// A Python file of the workspace that the page shows, and of which visitors may try other texts.
struct PlannedSource {
  std::string path;  ///< in what is installed
  std::string file;  ///< in the workspace
  std::string sha256;
};

/// Where the bytes of all of them lie in the site.
inline constexpr const char* kWorkspaceArchive = "python/workspace.zip";

struct PythonSite {
  std::vector<PythonSiteFile> files;
  std::vector<std::string> archives;  ///< paths of those among `files` that all nodes unpack
  std::map<std::string, std::string> compiled;  ///< and of those for who imports a compiled module
  std::vector<PlannedSource> sources;           ///< sorted by file
};

/// The archive of what the packages of the workspace bring, when they bring something.
inline constexpr const char* kPythonWorkspace = "python/workspace.zip";
/// And that of the modules that launch files are recorded with.
inline constexpr const char* kLaunchModules = "python/launch.zip";

/// The same files give the same bytes.
[[nodiscard]] std::string python_archive(const PythonFiles& files);

/// "share/demo/config/gains.yaml" or "share/ament_index/resource_index/plugins/demo": of "demo".
[[nodiscard]] std::string package_of_shared(const std::string& path);

/// `needed`: the compiled modules that some node imports. `local`: the packages of the workspace.
/// The same files give the same bytes.
[[nodiscard]] PythonSite python_site(PythonInput input, const InterfaceTexts& interfaces,
                                     const SharedFiles& shared, const std::set<std::string>& needed,
                                     const std::vector<std::string>& local,
                                     const std::vector<std::string>& packages);

}  // namespace ros2wasm
