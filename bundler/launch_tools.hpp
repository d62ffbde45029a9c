// What launch files in Python are read with. An edge: asks channels, fills the store.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "bundler/launch/python_host.hpp"

namespace ros2wasm {

/// Node.js, the reader, and Pyodide: of `environment` when that has it, else of the program's own
/// channel. R2W0517, R2W0620, R2W0912.
[[nodiscard]] Outcome<PythonTools> find_launch_tools(
    const std::filesystem::path& executable, const std::map<std::string, std::string>& variables,
    const std::filesystem::path& environment, const Cancellation& cancellation);

/// The interpreter for a world with these folders, which starts when it is needed.
[[nodiscard]] LaunchPython launch_python(const std::vector<LaunchFolder>& folders,
                                         std::function<Outcome<PythonTools>()> find_tools,
                                         const Cancellation& cancellation);

}  // namespace ros2wasm
