// Reads Python wheels (PEP 427) safely, into memory: nothing is written. libarchive ends in
// archive_library.cpp.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bundler/archive/extract_limits.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/wheel_name.hpp"

namespace ros2wasm {

struct Wheel {
  std::string project;  ///< as its METADATA names it
  std::string version;
  std::vector<std::string> requirements;     ///< Requires-Dist, as they are written
  std::string python;                        ///< Requires-Python; may be empty
  std::map<std::string, std::string> files;  ///< bytes by path below site-packages
  /// Compiled modules among the files: path -> names of the libraries that each needs.
  std::map<std::string, std::vector<std::string>> side_modules;
};

/// Modules and what lies among them, with the wheel's .dist-info; scripts, headers and data are
/// left out, and so are compiled .pyc files. `name` is what the wheel's file is called. What is in
/// memory at once is limited, whatever `limits` say. R2W0221 damaged or no wheel, R2W0222 a name
/// that leads outside, R2W0223 links, R2W0224 two members with one name or names that differ in
/// letter case only, R2W0225 over a limit, R2W0226 files that differ from RECORD, R2W0243 a wheel
/// of another project or version than its name says, or with compiled modules whatever its name
/// says, R2W0245 a compiled module that a site must not load.
[[nodiscard]] Outcome<Wheel> read_wheel(const std::filesystem::path& file, const WheelName& name,
                                        ExtractLimits limits);

/// Libraries that compiled modules of wheels need, as Pyodide's distribution packs them.
struct SharedLibraries {
  std::map<std::string, std::string> files;                ///< bytes by file name
  std::map<std::string, std::vector<std::string>> needed;  ///< as Wheel::side_modules has it
};

/// `name` is for messages. R2W0221..R2W0225, R2W0245.
[[nodiscard]] Outcome<SharedLibraries> read_shared_libraries(const std::filesystem::path& file,
                                                             const std::string& name,
                                                             ExtractLimits limits);

/// R2W0245: what read_side_module() has against a module.
[[nodiscard]] Diagnostic refused_side_module(const std::string& archive, const std::string& module,
                                             const std::string& why);

}  // namespace ros2wasm
