// Links without the compiler's driver and without the optimizer of whole programs: the driver is
// asked once how it calls the linker, then the linker is called like that. Ten times faster, for
// the rebuild of a changed file; the programs are larger.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/compiler.hpp"
#include "bundler/build/link_line.hpp"
#include "workspace_schema/cancellation.hpp"

namespace ros2wasm {

/// How the driver calls the linker: what stands before and after the objects of the program.
struct LinkerCall {
  std::string linker;
  std::vector<std::string> before;
  std::vector<std::string> after;
};

/// Read off what the driver prints with -v. `marker` is the object that stood for a program's
/// objects, `output` the file it wrote; both are left out. Nothing when it printed no such call.
[[nodiscard]] std::optional<LinkerCall> parse_linker_call(std::string_view printed,
                                                          std::string_view marker,
                                                          std::string_view output);

/// Arguments of the driver as the linker wants them. Nothing when one of them means something to
/// the driver itself, so that only the driver can link this.
[[nodiscard]] std::optional<std::vector<std::string>> linker_arguments(
    const std::vector<std::string>& driver_arguments);

/// Where the findings for a compiler lie.
[[nodiscard]] std::filesystem::path quick_links_folder(const std::filesystem::path& build_cache,
                                                       const Compiler& compiler);

struct QuickLink {
  const LinkLine& line;
  LinkKind kind;
  std::string stem;            ///< as in link_command()
  std::filesystem::path kept;  ///< folder for what the driver said, one per compiler
  std::map<std::string, std::string> environment;  ///< for the compiler
};

/// Writes `<stem>.wasm`, as link_command() would, and gives what the linker printed; nothing when
/// it must be linked the long way, which also knows the errors.
[[nodiscard]] std::optional<std::string> link_quickly(const QuickLink& link,
                                                      const Cancellation& cancellation);

}  // namespace ros2wasm
