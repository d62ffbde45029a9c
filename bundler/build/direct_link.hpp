// Links without the compiler's driver: it is asked once how it calls its tools, then they are
// called like that. What it does besides them (it looks through all objects, starts Python and
// Node.js, writes JavaScript) is not for programs of a site. The optimizer of whole programs can be
// left out for the rebuild of a changed file: that is faster again, and the programs are larger.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/compiler.hpp"
#include "bundler/build/link_line.hpp"
#include "workspace_schema/base/cancellation.hpp"

namespace ros2wasm {

/// How the driver calls its tools. The files that it works on are skipped.
struct ToolCalls {
  std::vector<std::string> linker;     ///< with what stands before the objects of the program
  std::vector<std::string> after;      ///< what stands after them
  std::vector<std::string> optimizer;  ///< wasm-opt, which finds the features in the program
};

/// Read off what the driver prints with -v. `marker` is the object that stood for a program's
/// objects, `output` the program. Nothing unless it printed one call of either.
[[nodiscard]] std::optional<ToolCalls> parse_tool_calls(std::string_view printed,
                                                        std::string_view marker,
                                                        std::string_view output);

/// Arguments of the driver as the linker wants them. Nothing when one of them means something to
/// the driver itself, so that only the driver can link this.
[[nodiscard]] std::optional<std::vector<std::string>> linker_arguments(
    const std::vector<std::string>& driver_arguments);

/// Where the findings for a compiler lie.
[[nodiscard]] std::filesystem::path tool_calls_folder(const std::filesystem::path& build_cache,
                                                      const Compiler& compiler);

struct DirectLink {
  const LinkLine& line;
  LinkKind kind;
  std::string stem;            ///< as in link_command()
  std::filesystem::path kept;  ///< folder for what the driver said, one per compiler
  std::map<std::string, std::string> environment;  ///< for the compiler
};

/// Writes `<stem>.wasm`, as link_command() would but for the optimizer, and gives what the linker
/// printed; nothing when it must be linked the long way, which also knows the errors.
[[nodiscard]] std::optional<std::string> link_directly(const DirectLink& link,
                                                       const Cancellation& cancellation);

/// `<stem>.wasm` becomes a program like that of link_command(), of the same size, in less time.
/// False: it must be linked the long way.
[[nodiscard]] bool optimize_directly(const DirectLink& link, const Cancellation& cancellation);

}  // namespace ros2wasm
