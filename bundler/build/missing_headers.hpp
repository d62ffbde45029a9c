// Programs that are skipped because they include a header that nothing gives.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/build/compile_errors.hpp"

namespace ros2wasm {

/// A header that a program includes and that no package has.
struct MissingHeader {
  std::string target;  ///< of CMake
  std::string header;
  SourceSpan place;  ///< of the include; the file is below the package's folder, or absolute
};

/// The file in the folder of a build, and of an installed package, that lists the missing headers
/// of skipped programs.
inline constexpr const char* kMissingHeaders = ".missing-headers";

/// When each command that failed is a compiler's, with no other error than a header that is not
/// found: those headers. Else nothing. Links are passed over. Pure.
[[nodiscard]] std::optional<std::vector<MissingHeader>> missing_headers(
    std::string_view ninja_output, const BuildPlace& place);

/// Could somebody have it: a package of the channels or of the workspace by its folder, the
/// package itself, or one of the prefixes? Looks into those folders.
[[nodiscard]] bool is_given(const MissingHeader& missing, const BuildPlace& place,
                            const std::vector<std::filesystem::path>& prefixes);

/// For the toolchain, which leaves a target out and says that it needs this. Pure.
[[nodiscard]] std::string left_out_line(const std::string& target, const std::string& need);

/// Such lines for all. Pure.
[[nodiscard]] std::string left_out_script(const std::vector<MissingHeader>& missing);

[[nodiscard]] Outcome<Done> write_missing_headers(const std::filesystem::path& prefix,
                                                  const std::vector<MissingHeader>& missing);

/// The stored findings of an installed package: R2W0522, warnings. Only R2W0502, errors, when a
/// package that is known by now has the header and should be depended on.
[[nodiscard]] Diagnostics left_out_programs(const std::filesystem::path& prefix,
                                            const BuildPlace& place);

}  // namespace ros2wasm
