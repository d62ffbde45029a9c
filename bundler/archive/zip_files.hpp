// Reads all files of a ZIP archive safely, into memory: nothing is written.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "bundler/archive/extract_limits.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct ZipFile {
  std::string bytes;
  bool executable = false;
};

/// By clean relative path. What is in memory at once is limited to `limits`. `name` is for
/// messages. R2W0210, R2W0221 damaged, R2W0222 a name that leads outside, R2W0223 links, R2W0224
/// two members with one name or names that differ in letter case only, R2W0225 over a limit.
[[nodiscard]] Outcome<std::map<std::string, ZipFile>> read_zip_files(
    const std::filesystem::path& file, const std::string& name, const ExtractLimits& limits);

/// Says why an archive is not taken.
[[nodiscard]] Diagnostic refused_archive(DiagnosticCode code, const std::string& name,
                                         std::vector<std::string> why);

}  // namespace ros2wasm
