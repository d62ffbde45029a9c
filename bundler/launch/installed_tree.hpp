// Looks into installed prefixes: which packages there are, their programs, their interface
// definitions. An edge: reads folders and files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/launch/launch_graph.hpp"
#include "bundler/plan/site_plan.hpp"

namespace ros2wasm {

/// Is it a file, and not by a link that leads out of `prefix`? `path`: below it.
[[nodiscard]] bool is_installed_file(const std::filesystem::path& prefix,
                                     const std::filesystem::path& path);

/// What is said after the path of one that is not.
inline constexpr const char* kLeadsElsewhere =
    ", a link to a folder or out of the installed packages";

/// What `package` put into lib/<package>/ of `prefix`, sorted by name. Names files (.names) and
/// links that lead out do not count.
[[nodiscard]] std::vector<InstalledProgram> installed_programs(const std::filesystem::path& prefix,
                                                               const std::string& package);

/// Programs that a package with a prefix of its own put into bin/, where ROS does not look; sorted.
[[nodiscard]] std::vector<std::string> programs_in_bin(const std::filesystem::path& prefix);

/// The packages in share/ of `prefix` (those with a package.xml), sorted, with their programs.
[[nodiscard]] std::vector<InstalledPackage> installed_packages(const std::filesystem::path& prefix);

/// Adds the .msg, .srv and .action files in share/<package>/ of `prefix`; a type that is known
/// stays.
void collect_interfaces(const std::filesystem::path& prefix, const std::string& package,
                        InterfaceTexts& into);

}  // namespace ros2wasm
