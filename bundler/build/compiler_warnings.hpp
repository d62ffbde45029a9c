// Findings of compilers and the link driver that do not fail a package. They are stored for each
// command, since ninja runs only the commands that must run, and with the package, so that a cached
// package reports them again.
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

/// The output file of a command -> its findings. Places are below the package's folder.
using CommandFindings = std::map<std::string, Diagnostics>;

/// The findings of the commands that ran, as ninja printed them. Commands without findings have an
/// entry too.
[[nodiscard]] CommandFindings command_findings(std::string_view ninja_output,
                                               const BuildPlace& place);

/// With what just ran, and without what is no longer made. `build_ninja` is the text of that file.
[[nodiscard]] CommandFindings current_findings(CommandFindings earlier, CommandFindings fresh,
                                               std::string_view build_ninja);

/// The findings of all commands, each once.
[[nodiscard]] Diagnostics all_findings(const CommandFindings& findings);

[[nodiscard]] CommandFindings read_command_findings(const std::filesystem::path& work);
Outcome<Done> write_command_findings(const std::filesystem::path& work,
                                     const CommandFindings& findings);

/// Stores the findings with an installed package; writes nothing when there are none.
Outcome<Done> keep_findings(const std::filesystem::path& prefix, const Diagnostics& findings);

/// The findings that are stored with an installed package, with places as the person sees them.
[[nodiscard]] Diagnostics kept_findings(const std::filesystem::path& prefix,
                                        const BuildPlace& place);

}  // namespace ros2wasm
