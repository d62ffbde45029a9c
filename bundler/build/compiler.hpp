// Finds Emscripten and says which one it is, without starting it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

using EnvironmentVariables = std::map<std::string, std::string>;

struct Compiler {
  std::filesystem::path cxx;   ///< em++
  std::filesystem::path c;     ///< emcc
  std::filesystem::path home;  ///< folder of its scripts
  std::string version;         ///< "3.1.6"
  /// Changes whenever the compiler, its clang or its system libraries do: goes into every build's
  /// hash.
  std::string identity;
};

/// EMSDK's compiler when that variable is set, else the one on PATH. R2W0501 when there is none.
[[nodiscard]] Outcome<Compiler> find_compiler(const EnvironmentVariables& variables);

/// For a machine without one, when nothing is compiled: of the newest of the versions in
/// `packaged`, so that the lock is that of a machine with a compiler.
[[nodiscard]] Compiler no_compiler(const std::vector<std::string>& packaged);

/// R2W0530 when none of the channels' packages was compiled by this compiler's version. `packaged`:
/// versions of the package emscripten-abi that the channels have; none means that they do not say.
[[nodiscard]] std::optional<Diagnostic> no_packages_for(const Compiler& compiler,
                                                        const std::vector<std::string>& packaged,
                                                        const EnvironmentVariables& variables);

/// The environment that Emscripten's tools need here: Debian's emcc finds its JavaScript libraries
/// through NODE_PATH, whichever Node.js runs it.
[[nodiscard]] EnvironmentVariables compiler_environment(const EnvironmentVariables& variables);

/// As compiler_environment(), for calls of the compiler and its tools. Debian's emcc runs the first
/// python3 and the first wasm-opt on PATH: those beside it come first, so that programs are the
/// same whatever else is installed (npm's binaryen runs in Node.js and takes several times as
/// long).
[[nodiscard]] EnvironmentVariables tool_environment(const EnvironmentVariables& variables,
                                                    const std::filesystem::path& compiler);

}  // namespace ros2wasm
