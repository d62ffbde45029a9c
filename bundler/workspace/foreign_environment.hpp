// The requests and locked packages in environment files of other tools: environment.yml, pixi.toml,
// pixi.lock and conda-lock files. Pure; a start for a workspace, never read again by `pack`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

struct ForeignEnvironment {
  std::string format;  ///< "environment.yml", "pixi.toml", "pixi.lock" or "conda-lock"
  std::string name;    ///< may be empty
  std::vector<std::string> channels;
  std::vector<std::string> specs;       ///< match specs; of a lock: its packages nobody needs
  std::vector<PackageRecord> packages;  ///< of a lock, by name
  std::vector<std::string> left_out;    ///< what has no place here, for people
};

/// `file` tells the format where the text does not, and is for messages. Of locks, the part for
/// emscripten-wasm32 is read: that of `environment`, or of "default", or of the first that has it.
/// R2W0340 not such a file, with its place; R2W0341 nothing in it is for emscripten-wasm32.
[[nodiscard]] Outcome<ForeignEnvironment> read_foreign_environment(std::string_view text,
                                                                   const std::string& file,
                                                                   const std::string& environment);

}  // namespace ros2wasm
