// How Node.js is started to run Pyodide with code of a workspace: setup.py files and launch files.
// The program (templates/python) decides which files the Python code sees. The options here also
// limit code that escapes from Python: it cannot read other files, write any, start programs, open
// sockets, see variables of the environment, or make JavaScript from text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/io/process.hpp"

namespace ros2wasm {

/// `folders`: what the program may read, real paths, itself among them. Node.js follows links, so
/// these folders must have none that lead out. `program`: a script and its arguments.
[[nodiscard]] ProcessRequest python_sandbox(const std::filesystem::path& node_js,
                                            const std::vector<std::filesystem::path>& folders,
                                            const std::vector<std::string>& program);

}  // namespace ros2wasm
