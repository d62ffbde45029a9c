// Compiles rclcpp's header once for all sources that begin with it: reading it is most of what
// compiling a node costs. What becomes of a source is the same, byte for byte.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/compiler.hpp"
#include "bundler/io/process.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The variable with the `kept` of `ros2wasm compile-source`.
inline constexpr const char* kKeptHeadersVariable = "ROS2WASM_KEPT_HEADERS";

/// The parts of a compiler's command that concern the header.
struct HeaderUse {
  std::filesystem::path source;
  std::vector<std::filesystem::path> own_folders;  ///< -I, in order, but for the packages'
  std::filesystem::path packages;                  ///< include folder with one of each package
  std::vector<std::string> flags;                  ///< that the header must be compiled with, too
};

/// Nothing when the command compiles no C++, does not see rclcpp, or does what is not known here.
[[nodiscard]] std::optional<HeaderUse> header_use(const std::vector<std::string>& command);

/// True when nothing but includes stands in a source, or in its own headers, before
/// rclcpp/rclcpp.hpp: then it matters to nobody that the header comes first.
[[nodiscard]] bool begins_with_header(const HeaderUse& use);

/// Where headers lie that this compiler has read.
[[nodiscard]] std::filesystem::path kept_headers_folder(const std::filesystem::path& build_cache,
                                                        const Compiler& compiler);

struct SourceCompilation {
  std::vector<std::string> command;  ///< the compiler and its arguments
  std::filesystem::path kept;        ///< empty: compile as the command says
  std::filesystem::path tool_calls;  ///< compiles as direct_compile.hpp says; may be empty
  EnvironmentVariables environment;  ///< for the compiler, see tool_environment()
};

/// Runs the command, with the kept header where that is possible; R2W0910 when there is no such
/// compiler. What is kept and no longer good is removed.
[[nodiscard]] Outcome<ProcessResult> compile_source(const SourceCompilation& compilation,
                                                    const Cancellation& cancellation);

}  // namespace ros2wasm
