// Runs the interpreter of launch files in Python: Pyodide under Node.js, which may read the named
// folders and nothing else of this machine. An edge: starts a process.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bundler/io/process.hpp"
#include "bundler/launch/host/launch_world.hpp"
#include "bundler/launch/host/python_transcript.hpp"

namespace ros2wasm {

struct PythonTools {
  std::filesystem::path node_js;
  std::filesystem::path pyodide;    ///< the folder with pyodide.js
  std::filesystem::path templates;  ///< templates/python
};

/// Starts when it is first asked; one process answers all.
class PythonHost {
 public:
  /// `find_tools` is called at the first question.
  PythonHost(std::function<Outcome<PythonTools>()> find_tools, std::vector<LaunchFolder> folders,
             Cancellation cancellation)
      : find_tools_(std::move(find_tools)),
        folders_(std::move(folders)),
        cancellation_(cancellation) {}

  /// As LaunchPython has it.
  [[nodiscard]] Outcome<std::string> ask(
      const std::string& request, const std::function<std::string(const std::string&)>& reply);

  /// The paths in the folders that the interpreter has looked at so far; nothing when it was never
  /// asked.
  [[nodiscard]] std::optional<SeenPaths> seen();

 private:
  [[nodiscard]] Outcome<Done> start();

  std::function<Outcome<PythonTools>()> find_tools_;
  std::vector<LaunchFolder> folders_;
  Cancellation cancellation_;
  std::unique_ptr<Conversation> conversation_;
};

}  // namespace ros2wasm
