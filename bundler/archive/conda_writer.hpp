// Writes a staged prefix as a .conda archive: the same files and metadata give the same bytes on
// every machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

struct CondaPackage {
  std::string name;  ///< lower case letters, digits, `-`, `_`, `.`
  std::string version;
  std::string build;
  std::uint64_t build_number = 0;
  std::string subdir;  ///< "emscripten-wasm32" or "noarch"
  NoarchKind noarch = NoarchKind::kNo;
  std::vector<std::string> depends;       ///< match specs
  std::vector<std::string> constrains;    ///< match specs
  std::vector<std::string> entry_points;  ///< of noarch python: "command = module:function"
  std::string license;                    ///< SPDX expression
  std::vector<std::filesystem::path> license_files;  ///< copied to info/licenses/
  std::string summary;                               ///< one line
  std::string home;                                  ///< URL, may be empty
  std::string source;                                ///< address and commit, may be empty
  std::int64_t timestamp_ms = 0;                     ///< 0: not written
  /// The absolute prefix that the files were installed for; where a text file holds it, paths.json
  /// says so and the reader replaces it. Empty: nothing is looked for.
  std::string placeholder;
};

/// The bytes of the archive. R2W0205 bad metadata, R2W0206 the prefix holds what cannot be packed
/// (device files, links that lead outside), R2W0210 a file cannot be read.
[[nodiscard]] Outcome<std::string> write_conda(const CondaPackage& package,
                                               const std::filesystem::path& staged_prefix);

/// "<name>-<version>-<build>.conda".
[[nodiscard]] std::string conda_file_name(const CondaPackage& package);

}  // namespace ros2wasm
