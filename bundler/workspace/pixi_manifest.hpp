// The part of a pixi.toml that a workspace can take over: name, channels and conda dependencies.
// Pure.
#pragma once

#include <string>
#include <string_view>

#include "bundler/workspace/foreign_environment.hpp"

namespace ros2wasm {

/// R2W0340 with line and column.
[[nodiscard]] Outcome<ForeignEnvironment> read_pixi_manifest(std::string_view text,
                                                             const std::string& file);

}  // namespace ros2wasm
