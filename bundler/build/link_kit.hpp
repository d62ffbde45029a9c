// How a program, or a library of plugins, is linked: its link line with copies of the files that
// lie where it was built, so that it can be linked again, with more, when all packages are built.
// An edge to the disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/link_line.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The variable with the folder in which `ros2wasm link-program` leaves kits.
inline constexpr const char* kLinkKitsVariable = "ROS2WASM_LINK_KITS";

/// The package of the base class, when the line is that of a library of plugins, which is written
/// down and not linked.
[[nodiscard]] std::optional<std::string> plugins_of(const LinkLine& line);

/// Whether a program of these arguments loads plugins.
[[nodiscard]] bool loads_plugins(const std::vector<std::string>& arguments);

/// Writes the kit of a library of plugins, of a program that loads plugins, or of a container of
/// components, below `kits`. Another program has no kit afterwards. R2W0210, R2W0211.
[[nodiscard]] Outcome<Done> keep_link_kit(const std::filesystem::path& kits, const LinkLine& line);

/// The kits that a build left for what is installed in `prefix`, into that prefix: of plugins those
/// that the last configure named. R2W0210, R2W0211.
[[nodiscard]] Outcome<Done> install_link_kits(const std::filesystem::path& kits,
                                              const std::filesystem::path& prefix,
                                              const std::string& package);

/// The same for a package of a channel, which is unpacked elsewhere, beside those of `environment`
/// that it was built with: its kits name their files by the place in a prefix. Containers of
/// components have none. R2W0505 also when a program needs a file that is in no package.
[[nodiscard]] Outcome<Done> install_movable_kits(const std::filesystem::path& kits,
                                                 const std::filesystem::path& prefix,
                                                 const std::string& package,
                                                 const std::filesystem::path& environment);

/// In a prefix: a folder for each package that has kits.
inline constexpr const char* kLinkKitFolder = "link_kits/";

/// The same for kits that install_link_kits() has put into a prefix of which `prefix` is a copy:
/// `prefixes` are the packages that the package was built with, and its own place. R2W0210,
/// R2W0211, R2W0505.
[[nodiscard]] Outcome<Done> make_kits_movable(const std::filesystem::path& prefix,
                                              const std::string& package,
                                              const std::vector<std::filesystem::path>& prefixes);

struct LinkKit {
  std::string name;                    ///< of the program, or of the library's kit
  std::string base;                    ///< the package of the base class, of plugins
  std::vector<std::string> arguments;  ///< after the compiler, without -o
};

/// The packages in `prefix` that have kits, sorted.
[[nodiscard]] std::vector<std::string> packages_with_kits(const std::filesystem::path& prefix);

/// The kits of a package that is installed in `prefix`, sorted by base and name.
[[nodiscard]] Outcome<std::vector<LinkKit>> program_kits(const std::filesystem::path& prefix,
                                                         const std::string& package);
[[nodiscard]] Outcome<std::vector<LinkKit>> plugin_kits(const std::filesystem::path& prefix,
                                                        const std::string& package);

}  // namespace ros2wasm
