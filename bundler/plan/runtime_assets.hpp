// The built runtime that goes into every site: runtime_assets.json and the files beside it. An
// edge: reads files.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "bundler/plan/site_plan.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// Of the file that says what the others are made of. It is in no site as it is.
inline constexpr std::string_view kComponentsRole = "components";

/// The role of the script of a course's page, which is in no site.
inline constexpr std::string_view kCourseScriptRole = "course_script";

/// Reads and checks all files against their sizes and hashes. R2W0604 the list or a file is
/// damaged.
[[nodiscard]] Outcome<std::vector<RuntimeAsset>> read_runtime_assets(
    const std::filesystem::path& list);

/// What these are made of, ros2wasm and packages of npm, and then `others`. R2W0604 they do not say
/// it.
[[nodiscard]] Outcome<std::vector<SiteComponent>> with_runtime_components(
    const std::vector<RuntimeAsset>& assets, std::vector<SiteComponent> others);

}  // namespace ros2wasm
