// The built runtime that goes into every site: runtime_assets.json and the files beside it. An
// edge: reads files.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "bundler/plan/plan_site.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The role of the file that lists the components of the others. No site has this file itself.
inline constexpr std::string_view kComponentsRole = "components";

/// The role of the script of a course's page, which is in no site.
inline constexpr std::string_view kCourseScriptRole = "course_script";

/// Reads and checks all files against their sizes and hashes. R2W0604 the list or a file is
/// damaged.
[[nodiscard]] Outcome<std::vector<RuntimeAsset>> read_runtime_assets(
    const std::filesystem::path& list);

/// The components of these assets, ros2wasm and packages of npm, and then `others`. R2W0604 when
/// the assets do not list them.
[[nodiscard]] Outcome<std::vector<SiteComponent>> with_runtime_components(
    const std::vector<RuntimeAsset>& assets, std::vector<SiteComponent> others);

}  // namespace ros2wasm
