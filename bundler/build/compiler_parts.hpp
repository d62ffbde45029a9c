// The parts of Emscripten, besides its version, that decide what is in programs: clang and the
// system libraries. Read from the disk; no tool is started.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/compiler.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

struct CompilerParts {
  std::filesystem::path clang;                   ///< empty: not found
  std::string clang_version;                     ///< "14.0.6"; empty: not known
  std::vector<std::filesystem::path> libraries;  ///< those that programs get, sorted by name
  bool has_all_libraries = false;  ///< Emscripten makes some when they are first needed
};

[[nodiscard]] CompilerParts find_compiler_parts(const std::filesystem::path& emscripten,
                                                const EnvironmentVariables& variables);

/// Changes whenever one of them does, on this machine: places, sizes and times.
[[nodiscard]] std::string stamp_of(const CompilerParts& parts);

/// The build string of the package emscripten-abi, which locks record:
/// "clang14.0.6_h0123456789ab_0", with a hash of the libraries' names and contents, the same on
/// every machine that has them. Empty where clang or a library is not known. `cache`: keeps it by
/// their stamp; may be empty.
[[nodiscard]] std::string abi_build(const CompilerParts& parts, const std::filesystem::path& cache);

/// R2W0530 when the channels have packages of this compiler's version, but of other parts.
/// `packaged`: build strings of emscripten-abi of that version; those of older channels say
/// nothing.
[[nodiscard]] std::optional<Diagnostic> other_parts(const Compiler& compiler,
                                                    const std::string& own_build,
                                                    const std::vector<std::string>& packaged);

/// The compiler that was found, or a substitute when none was; R2W0530 when the packages do not fit
/// it. `packaged`: those of emscripten-abi.
[[nodiscard]] Outcome<Compiler> fitting_compiler(Outcome<Compiler> found,
                                                 const std::vector<PackageRecord>& packaged,
                                                 const EnvironmentVariables& variables,
                                                 const std::filesystem::path& cache);

}  // namespace ros2wasm
