// Compiles without the compiler's driver: it is asked once, for each way to compile, what it hands
// to clang besides the arguments that it is given. The driver is a program of Python, and starting
// it takes as long as compiling a small source does.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/cancellation.hpp"

namespace ros2wasm {

/// A command to compile one source, as the driver sees it.
struct CompileWords {
  std::string source;
  std::string output;
  std::vector<std::string> manner;  ///< arguments that the driver may have something to add to;
                                    ///< includes, macros, warnings and the like are not among them
};

/// Nothing when the command does not compile one source of C or C++ into one object.
[[nodiscard]] std::optional<CompileWords> compile_words(const std::vector<std::string>& command);

/// clang and what the driver puts before the arguments, read off what it prints with -v when it is
/// given -v, `manner`, and the two files. Nothing when it hands the arguments on changed.
[[nodiscard]] std::optional<std::vector<std::string>> parse_compiler_call(
    std::string_view printed, const std::vector<std::string>& manner, std::string_view source,
    std::string_view output);

/// The command with clang in place of the driver, `command` itself when only the driver can
/// compile this. `kept`: folder for what the driver said, one per compiler; empty asks nobody.
[[nodiscard]] std::vector<std::string> direct_compile_command(
    const std::vector<std::string>& command, const std::filesystem::path& kept,
    const std::map<std::string, std::string>& environment, const Cancellation& cancellation);

}  // namespace ros2wasm
