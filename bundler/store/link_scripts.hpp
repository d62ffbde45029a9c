// Link scripts of packages: programs that conda runs when it installs or removes a package. They
// are never run here; they are found and shown.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/store/store.hpp"
#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct LinkScript {
  std::string package;  ///< who brought it
  std::string path;     ///< relative to the prefix
};

/// Those in a prefix that `records` were installed into in this order; sorted by path. Each belongs
/// to the package that brought it, which need not be the one it is named for. R2W0210.
[[nodiscard]] Outcome<std::vector<LinkScript>> link_scripts_in(
    const std::filesystem::path& prefix, const std::vector<PackageRecord>& records,
    const Store& store);

/// R2W0227 for each script of a package that is not in `ignored` (letter case does not count), with
/// the script's text. Pure but
/// for reading it.
[[nodiscard]] Diagnostics refused_link_scripts(const std::filesystem::path& prefix,
                                               const std::vector<LinkScript>& scripts,
                                               const std::vector<std::string>& ignored);

}  // namespace ros2wasm
