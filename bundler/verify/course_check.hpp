// Checks a course against its hashes: its own files by course.json, each lab by its site.json.
#pragma once

#include <filesystem>

#include "bundler/verify/site_check.hpp"

namespace ros2wasm {

/// As check_site_folder(); the list has the files of all labs, its hash is that of course.json.
/// R2W0652 a lab is another site than course.json says.
[[nodiscard]] Outcome<SiteCheck> check_course_folder(const std::filesystem::path& folder,
                                                     const Cancellation& cancellation,
                                                     const ProgressSink& progress);

}  // namespace ros2wasm
