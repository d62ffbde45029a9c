// How a program, or a library of plugins, is linked: its link line with copies of the files that
// lie where it was built, so that it can be linked again, with more, when all packages are built.
// An edge to the disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/build/link_line.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// The variable with the folder in which `ros2wasm link-program` leaves kits.
inline constexpr const char* kLinkKitsVariable = "ROS2WASM_LINK_KITS";

/// The package of the base class, when the line is that of a library of plugins, which is written
/// down and not linked.
[[nodiscard]] std::optional<std::string> plugins_of(const LinkLine& line);

/// Does a program of this line load plugins?
[[nodiscard]] bool loads_plugins(const LinkLine& line);

/// Writes the kit of a line below `kits`: of a library of plugins, else of a program.
[[nodiscard]] Outcome<Done> write_link_kit(const std::filesystem::path& kits, const LinkLine& line);

/// The kits that a build left for what is installed in `prefix`, into that prefix.
[[nodiscard]] Outcome<Done> install_link_kits(const std::filesystem::path& kits,
                                              const std::filesystem::path& prefix,
                                              const std::string& package);

struct LinkKit {
  std::string name;                    ///< of the program, or of the library's kit
  std::string base;                    ///< the package of the base class, of plugins
  std::vector<std::string> arguments;  ///< after the compiler, without -o
};

/// Of a package in `prefix`, sorted by base and name.
[[nodiscard]] Outcome<std::vector<LinkKit>> program_kits(const std::filesystem::path& prefix);
[[nodiscard]] Outcome<std::vector<LinkKit>> plugin_kits(const std::filesystem::path& prefix);

}  // namespace ros2wasm
