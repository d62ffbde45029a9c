// The environment that a command gets from main: the console, cancellation, variables and so on, so
// that tests can pass their own.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

class Console;

struct Context {
  Console& console;
  Cancellation cancellation;
  ProgressSink progress;                           ///< shown by the console
  std::filesystem::path executable;                ///< absolute path of this program
  std::map<std::string, std::string> environment;  ///< variables at start
  bool json = false;                               ///< --json: print results as JSON

  /// The value of an environment variable; empty when it is not set.
  [[nodiscard]] std::string variable(const std::string& name) const {
    const auto found = environment.find(name);
    return found == environment.end() ? std::string() : found->second;
  }
};

/// Runs a command whose options are parsed; returns the exit code (see docs/errors.md). Usually
/// ends with `return context.console.fail(errors);` or `return 0;`.
using CommandBody = std::function<int(Context&)>;

}  // namespace ros2wasm
