// The command line that runs a packed site in Node.js.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct HeadlessRun {
  std::filesystem::path site;
  std::optional<std::chrono::milliseconds> limit;  ///< `--for`
  std::optional<std::string> until;                ///< a JavaScript regular expression
  std::string link;                  ///< "shared", "port", or empty: the runtime chooses
  bool stepped = false;              ///< with the shared link only
  std::optional<int> seed;           ///< of a stepped run
  std::optional<std::string> trace;  ///< file that the messages sent are written to
  std::optional<std::string> bags;   ///< folder that bags of nodes are written to
  bool checks = false;               ///< ends when the site's checks are decided
  std::optional<std::string> junit;  ///< file for their result
  bool json = false;
  std::vector<std::string> given;  ///< launch arguments, `name:=value` each
  bool show_arguments = false;     ///< instead of running anything
};

/// Runs a site.
inline constexpr std::string_view kHeadlessRole = "headless";
/// Runs a command of `ros2` on a site.
inline constexpr std::string_view kRos2Role = "headless_ros2";

/// A program of the runtime for Node.js: the file of that role in runtime_assets.json. R2W0912
/// the installation has no runtime, R2W0604 its list is damaged, R2W0623 it has no such file.
[[nodiscard]] Outcome<std::filesystem::path> find_headless_program(
    const std::filesystem::path& executable, std::string_view role = kHeadlessRole);

/// Nothing when Node.js takes `pattern` as a regular expression; else R2W0622 with its reason.
[[nodiscard]] Outcome<Done> check_pattern(const std::filesystem::path& node_js,
                                          const std::string& pattern,
                                          const Cancellation& cancellation);

/// Pure.
[[nodiscard]] std::vector<std::string> headless_command(const std::filesystem::path& node_js,
                                                        const std::filesystem::path& program,
                                                        const HeadlessRun& run);

}  // namespace ros2wasm
