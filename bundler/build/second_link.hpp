// Links a program once more when all packages are built, from kits (link_kit.hpp): with what only
// then is known to be in it. An edge: runs the linker.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/build/build_workspace.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct SecondLink {
  const BuiltPackage& package;         ///< that has the program
  std::string program;                 ///< its name
  std::string hash;                    ///< changes with all that it is linked from
  std::vector<std::string> arguments;  ///< after the compiler, without -o
};

/// The program's file, `lib/PACKAGE/PROGRAM.wasm` of a folder of the cache, where it is kept under
/// the hash. R2W0504 and R2W0505 as for any program.
[[nodiscard]] Outcome<std::filesystem::path> link_again(SecondLink link, const BuildTools& tools,
                                                        const std::filesystem::path& cache,
                                                        const Cancellation& cancellation,
                                                        const ProgressSink& progress);

}  // namespace ros2wasm
