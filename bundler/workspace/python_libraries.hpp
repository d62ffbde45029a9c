// The libraries of Pyodide's distribution, as the lock file of Pyodide lists them: which module is
// of which project, what it depends on, and what the file of each must be. Pure.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {

struct PythonLibraries {
  std::string index;                                ///< address of the distribution, with "/"
  std::map<std::string, LockedLibrary> by_project;  ///< normal_project_name()
  std::map<std::string, std::string> project_of;    ///< by top-level module
};

/// `text` is a pyodide-lock.json. R2W0128 it is none, or of another ABI. `file` is for messages.
[[nodiscard]] Outcome<PythonLibraries> read_python_libraries(std::string_view text,
                                                             const std::string& file);

/// The project that a rosdep key (`python3-opencv`, `python3-pandas-pip`), a module or a name of
/// pip stands for; empty: none of the distribution.
[[nodiscard]] std::string library_project(std::string_view name, const PythonLibraries& libraries);

/// The projects that these need, and themselves, where `locked` has them; what is needed comes
/// first. Sorted otherwise.
[[nodiscard]] std::vector<std::string> libraries_in_order(
    const std::set<std::string>& projects,
    const std::map<std::string, std::vector<std::string>>& depends);

/// A part of a library that the embedded channel has under the library's name, for sites that need
/// no more. Nothing: there is none for this module. `module` is "scipy.spatial.transform", `names`
/// what is imported from it, `attributes` what is used of it.
[[nodiscard]] std::optional<bool> stand_in_has(std::string_view module,
                                               const std::vector<std::string>& names,
                                               const std::vector<std::string>& attributes = {});

}  // namespace ros2wasm
