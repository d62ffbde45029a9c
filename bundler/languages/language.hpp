// How a package is built, by the build type of its package.xml: one row and one file per kind.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/build/build_package.hpp"

namespace ros2wasm {

/// The builder in the row of a build type, or null.
[[nodiscard]] PackageBuilder* builder_of(std::string_view build_type);

/// All build types that have a row, for messages.
[[nodiscard]] std::vector<std::string> known_build_types();

Outcome<Done> build_with_cmake(const PackageBuild& request, const BuildTools& tools,
                               const Cancellation& cancellation, const ProgressSink& progress);

Outcome<Done> build_with_setup_py(const PackageBuild& request, const BuildTools& tools,
                                  const Cancellation& cancellation, const ProgressSink& progress);

}  // namespace ros2wasm
