// From what ninja, cmake and the link driver print to diagnostics. Pure.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Emscripten's wrappers repeat the compiler's or linker's whole command when it failed. That line
/// is not part of the tool's own message.
[[nodiscard]] std::string without_wrapper_lines(std::string_view text);

/// The reason when a tool's output says that it had no memory, or that it was killed, as systems do
/// for lack of memory; else empty.
[[nodiscard]] std::string lack_of_memory(std::string_view text);

/// R2W0521: `what`, for this reason.
[[nodiscard]] Diagnostic out_of_memory(std::string what, std::string reason);

[[nodiscard]] std::vector<std::string> output_lines(std::string_view text);

/// A number that a tool printed: a line, a column, a part of a version. 0 when it is too large,
/// since a package can print anything.
[[nodiscard]] std::uint32_t printed_number(std::string_view digits);

/// "[3/7] Building ..." or "ninja: ...": ninja speaking, not the command.
[[nodiscard]] bool is_ninja_line(const std::string& line);

/// One command that failed, as ninja reports it.
struct FailedCommand {
  std::string output_file;  ///< what it should have made
  std::string command;
  std::string text;  ///< everything it printed
};

[[nodiscard]] std::vector<FailedCommand> failed_commands(std::string_view ninja_output);

struct BuildPlace {
  std::string package;
  std::filesystem::path source;  ///< folder of package.xml
  std::string display;           ///< how messages name that folder; may be empty
  std::string compiler_version;
  std::vector<std::string>
      channel_packages;  ///< ROS names that the channels have, sorted: for advice
};

/// How a message names a file: below the package as the person sees it, else as it is.
[[nodiscard]] std::string display_file(const std::string& file, const BuildPlace& place);

/// Is it a link, whose driver hands its findings up itself?
[[nodiscard]] bool is_link(const FailedCommand& failed);

/// Each error of a compiler's output, in its own words, with its place.
[[nodiscard]] Diagnostics compiler_messages(std::string_view text, const BuildPlace& place);

/// R2W0502, one per file that does not compile, each with the compiler's whole message. Commands of
/// other kinds become R2W0506, and R2W0521 those that had no memory.
[[nodiscard]] Diagnostics compile_errors(std::string_view ninja_output, const BuildPlace& place);

/// R2W0503 CMakeLists.txt failed, R2W0507 find_package() asked for what is not there.
/// `cmake_output` is both streams.
[[nodiscard]] Diagnostics configure_errors(std::string_view cmake_output, const BuildPlace& place);

}  // namespace ros2wasm
