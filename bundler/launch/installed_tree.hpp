// Looks into installed prefixes: which packages there are, their programs, their interface
// definitions. An edge: reads folders and files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/launch/launch_graph.hpp"
#include "bundler/plan/site_plan.hpp"

namespace ros2wasm {

/// What `package` put into lib/<package>/ of `prefix`, sorted by name. Names files (.names) do not
/// count.
[[nodiscard]] std::vector<InstalledProgram> installed_programs(const std::filesystem::path& prefix,
                                                               const std::string& package);

/// The packages in share/ of `prefix` (those with a package.xml), sorted, with their programs.
[[nodiscard]] std::vector<InstalledPackage> installed_packages(const std::filesystem::path& prefix);

/// Adds the .msg, .srv and .action files in share/<package>/ of `prefix`; a type that is known
/// stays.
void collect_interfaces(const std::filesystem::path& prefix, const std::string& package,
                        InterfaceTexts& into);

}  // namespace ros2wasm
