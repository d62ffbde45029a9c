// The Python files of installed packages: modules, and scripts that are programs. An edge: reads
// folders and files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Where Python looks for modules, below a prefix. The toolchain's ament_cmake_python says the same
/// to CMake.
inline constexpr const char* kPythonModules = "lib/python3.12/site-packages";
/// Where the package `pyodide` of a channel has its files, below the prefix.
/// Reads the setup.py of Python packages and launch files in Python, and runs Python nodes.
inline constexpr std::string_view kPyodidePackage = "pyodide";
inline constexpr const char* kPyodideFolder = "share/pyodide";

/// Bytes by path below the prefix: "lib/python3.12/site-packages/demo/talker.py".
using PythonFiles = std::map<std::string, std::string>;

/// Files that cannot be included and the reasons, for people.
using LeftOut = std::vector<std::string>;

/// Adds the modules of a prefix, and what `package` has in lib/<package>/ but compiled programs; a
/// file that is known stays. R2W0210.
[[nodiscard]] Outcome<LeftOut> collect_python_modules(const std::filesystem::path& prefix,
                                                      PythonFiles& into);
[[nodiscard]] Outcome<LeftOut> collect_python_scripts(const std::filesystem::path& prefix,
                                                      const std::string& package,
                                                      PythonFiles& into);

/// R2W0517. `why`: what needs it.
[[nodiscard]] Diagnostic no_pyodide(std::string why);

}  // namespace ros2wasm
