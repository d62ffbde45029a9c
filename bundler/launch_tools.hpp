// The tools that read launch files in Python. An edge: reads channels, fills the store.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bundler/launch/host/python_host.hpp"
#include "bundler/workspace/python_tree.hpp"

namespace ros2wasm {

/// Node.js, the reader, and Pyodide: of `environment` when that has it, else of the program's own
/// channel. R2W0517, R2W0620, R2W0912.
[[nodiscard]] Outcome<PythonTools> find_launch_tools(
    const std::filesystem::path& executable, const std::map<std::string, std::string>& variables,
    const std::filesystem::path& environment, const Cancellation& cancellation);

/// The inputs, besides the files that it looks at, that determine the answers of the interpreter of
/// one evaluation.
struct LaunchEvaluationAsked {
  std::filesystem::path executable;
  std::map<std::string, std::string> variables;
  std::filesystem::path environment;  ///< as find_launch_tools() takes it
  std::vector<LaunchFolder> folders;
  std::string file;                          ///< as launch files see it
  std::map<std::string, std::string> given;  ///< launch arguments
};

/// The interpreter of one evaluation, or of several that follow from it.
struct LaunchInterpreter {
  LaunchPython python;         ///< starts when it is needed
  std::function<void()> keep;  ///< call it when all went well: the next time need not start it
  /// The files that it has looked at so far; empty when it was never asked.
  std::function<Outcome<SeenPaths>()> seen;
};

/// The modules that launch files in Python are recorded with, by path, for sites that run them
/// again. R2W0210, R2W0912.
[[nodiscard]] Outcome<PythonFiles> launch_modules(const std::filesystem::path& executable);

/// The answers of an earlier evaluation stay valid while all files that the interpreter looked at
/// are unchanged: then no interpreter is started. They are cached in `<cache>/launch`.
[[nodiscard]] LaunchInterpreter launch_interpreter(const LaunchEvaluationAsked& asked,
                                                   const Cancellation& cancellation);

}  // namespace ros2wasm
