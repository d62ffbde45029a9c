// Writes the first workspace.yaml of a colcon workspace, for a person to go on with. Pure: packages
// and the texts of their build files in, YAML out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// A package as far as the draft needs it.
struct DraftPackage {
  std::string name;
  std::string version;
  std::string license;
  std::string build_type;             ///< "ament_cmake"
  std::string folder;                 ///< relative to the manifest, with `/`
  std::vector<std::string> programs;  ///< see installed_program_names
};

struct DraftInput {
  std::string name;  ///< a valid workspace name
  std::string title;
  std::vector<DraftPackage> packages;     ///< sorted by folder
  std::vector<std::string> launch_files;  ///< relative to the manifest
  std::vector<std::string> channels;      ///< none: what a manifest without them has
  std::vector<std::string> dependencies;  ///< match specs, beyond what the packages ask for
};

/// Names of the executables that a CMakeLists.txt makes and installs, sorted. Names that CMake puts
/// together from variables other than PROJECT_NAME are not seen.
[[nodiscard]] std::vector<std::string> installed_program_names(std::string_view cmake_lists);

/// The same for a Python package: the names before `=` of console_scripts in setup.py or setup.cfg.
[[nodiscard]] std::vector<std::string> console_script_names(std::string_view setup_py,
                                                            std::string_view setup_cfg);

/// The manifest's text, with comments on what a person may choose. A manifest says what runs: where
/// no package has a program, a node stands in it for a person to fill in.
[[nodiscard]] std::string draft_manifest(const DraftInput& input);

}  // namespace ros2wasm
