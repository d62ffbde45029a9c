// The files that Python nodes need in a site: Pyodide, and archives of what is installed. Pure.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "bundler/render/site_plan.hpp"
#include "bundler/workspace/installed_tree.hpp"
#include "bundler/workspace/python_tree.hpp"
#include "bundler/workspace/share_tree.hpp"

namespace ros2wasm {

/// Pyodide's wasm file in a site: the program of every Python node.
inline constexpr const char* kPythonProgram = "pyodide/pyodide.asm.wasm";

/// A library with compiled modules, which only programs that import it unpack.
struct LibraryInput {
  PythonFiles files;
  std::vector<std::string> load;  ///< those that are loaded before any code, in this order
};

/// The files that Python nodes find installed.
struct PythonInput {
  PythonFiles pyodide;    ///< by name
  PythonFiles channels;   ///< modules and scripts of the packages of channels
  PythonFiles wheels;     ///< of the manifest
  PythonFiles workspace;  ///< and of the workspace's
  std::map<std::string, LibraryInput> libraries;  ///< by project
  std::set<std::string> for_all;                  ///< projects that every program unpacks
  std::map<std::string, std::vector<std::string>> library_needs;  ///< of all that could be there
  /// The files of `workspace` with a source in the workspace: installed path -> path in the
  /// workspace.
  std::map<std::string, std::string> sources;
};

struct PythonSiteFile {
  std::string path;
  std::string reason;
  std::string bytes;
};

/// Where the bytes of all of them lie in the site.
inline constexpr const char* kWorkspaceArchive = "python/workspace.zip";

struct PythonSite {
  std::vector<PythonSiteFile> files;
  std::vector<std::string> archives;  ///< paths of those among `files` that all nodes unpack
  std::map<std::string, std::string> compiled;   ///< and of those for who imports a compiled module
  std::map<std::string, std::string> libraries;  ///< the same for libraries, by project
  std::map<std::string, std::vector<std::string>> load;  ///< LibraryInput::load, by project
  std::vector<PlannedSource> sources;                    ///< sorted by file
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
