// What compilers and the link driver said of a package without failing: kept from command to
// command, as ninja runs only those that must, and with the package, so that the cache tells it
// again.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/build/compile_errors.hpp"
#include "bundler/build/diagnostic_json.hpp"

namespace ros2wasm {

/// R2W0525, warnings of the compiler in files of the package itself, each once and whole.
[[nodiscard]] Diagnostics compiler_warnings(std::string_view text, const BuildPlace& place);

/// What a command made -> what it said. Places are below the package's folder.
using CommandFindings = std::map<std::string, Diagnostics>;

/// Of the commands that ran, as ninja printed them; those that said nothing too.
[[nodiscard]] CommandFindings command_findings(std::string_view ninja_output,
                                               const BuildPlace& place);

/// With what just ran, and without what is no longer made. `build_ninja` is the text of that file.
[[nodiscard]] CommandFindings current_findings(CommandFindings earlier, CommandFindings fresh,
                                               std::string_view build_ninja);

/// Of all commands, each finding once.
[[nodiscard]] Diagnostics all_findings(const CommandFindings& findings);

[[nodiscard]] CommandFindings read_command_findings(const std::filesystem::path& work);
Outcome<Done> write_command_findings(const std::filesystem::path& work,
                                     const CommandFindings& findings);

/// With an installed package; nothing is written when there is nothing to tell.
Outcome<Done> keep_findings(const std::filesystem::path& prefix, const Diagnostics& findings);

/// What an installed package says of itself, with places as the person sees them.
[[nodiscard]] Diagnostics kept_findings(const std::filesystem::path& prefix,
                                        const BuildPlace& place);

}  // namespace ros2wasm
