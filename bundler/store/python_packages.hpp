// Packages with `noarch: python`: one archive for every Python, whose files go where the Python of
// the environment looks for them (CEP 17, CEP 34). No .pyc is made and no command is written.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// The folder of modules below the prefix: "lib/python3.13/site-packages", or what the package
/// `python` says of itself. `folders[i]` is the unpacked `records[i]`. Empty when no record has
/// `noarch: python`. R2W0242 when one has, and there is no `python` or not one of that kind.
[[nodiscard]] Outcome<std::string> site_packages_of(
    const std::vector<PackageRecord>& records, const std::vector<std::filesystem::path>& folders);

/// Where a file of such a package goes: "site-packages/x" below `site_packages`,
/// "python-scripts/x" to "bin/x"; other files stay where they are. Pure.
[[nodiscard]] std::string path_in_prefix(const std::string& path, std::string_view site_packages);

}  // namespace ros2wasm
