// How Node.js is started to run Pyodide with code of a workspace: setup.py files and launch files.
// What the Python code may see is up to the program (templates/python); here is what not even code
// that got out of Python can do: read other files, write any, start programs, open sockets, see
// variables of the environment, or make JavaScript of text.
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
