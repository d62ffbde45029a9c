// Rules for names, versions and build strings in a channel (CEP 26) and in a lock. They also ensure
// that no field of a record can lead out of a folder. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

enum class Strictness {
  kReading,  ///< what old channels have is accepted as long as it is harmless
  kWriting,  ///< what CEP 26 asks of new packages
};

/// The first thing that is wrong with the record's name, version, build, subdir or file name;
/// nothing when all is well.
[[nodiscard]] std::optional<std::string> record_fault(const PackageRecord& record,
                                                      Strictness strictness);

/// "linux-64", "emscripten-wasm32", "noarch".
[[nodiscard]] bool is_subdir(std::string_view text);

/// "x-1.0-0" for both "x-1.0-0.conda" and "x-1.0-0.tar.bz2"; empty when the name has neither
/// ending.
[[nodiscard]] std::string_view archive_stem(std::string_view file_name);

}  // namespace ros2wasm
