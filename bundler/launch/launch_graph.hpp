// The processes of the site: one entry each, with its place in the source. Pure values.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/launch_step.hpp"
#include "bundler/launch/node_arguments.hpp"
#include "bundler/workspace/installed_tree.hpp"
#include "bundler/workspace/skipped_packages.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct LaunchNode {
  std::string id;  ///< `<executable>-<n>`, as ros2 launch names processes
  std::string package;
  std::string executable;
  std::vector<std::string> linked_with = {};  ///< as NodeEntry has it, sorted
  std::string label;  ///< for people: the node's full name when it is known, else the executable
  std::filesystem::path program;  ///< the installed file; with `linked_with`, where it will be; of
                                  ///< a command none
  ProgramKind kind = ProgramKind::kWasm;
  std::vector<std::string> compiled_modules;  ///< that a Python program imports: "numpy"
  std::vector<std::string> libraries = {};    ///< projects; what is needed comes first
  std::vector<std::string> arguments;         ///< after argv[0], as ros2 launch would pass them
  NodeOutput output = NodeOutput::kScreen;
  bool respawn = false;
  std::map<std::string, std::string> environment;  ///< beside the site's own
  LaunchMoment start_on;
  double start_after_s = 0;
  double respawn_delay_s = 0;
  std::optional<std::int64_t> respawn_max_retries;  ///< else as often as it ends
  bool shutdown_on_exit = false;                    ///< when it ends, all ends
  SourceSpan source;
};

/// The name of a container's program; of another program that of the executable.
[[nodiscard]] std::string program_name(const NodeEntry& entry);

/// Where a Python node's script lies, below the prefix.
[[nodiscard]] std::string python_script(const LaunchNode& node);

/// A parameter file that was read, by the path the manifest gives.
using ParameterFiles = std::map<std::string, std::string>;

/// R2W0401 for each node of a package that is not among these.
[[nodiscard]] Diagnostics missing_packages(const std::vector<NodeEntry>& entries,
                                           const std::vector<std::string>& packages,
                                           const LeftOutChains& left_out = {});

/// The rules in the parameter files of an entry, in its order. Errors of these files.
[[nodiscard]] Outcome<std::vector<FileRules>> file_rules(const NodeEntry& entry,
                                                         const ParameterFiles& parameter_files);

/// Checks the manifest's nodes against what is installed. R2W0401 no such package, R2W0402 no such
/// executable, R2W0405 it is not a program for the site; errors of parameter files. All at once.
[[nodiscard]] Outcome<std::vector<LaunchNode>> launch_nodes(
    const std::vector<NodeEntry>& entries, const std::vector<InstalledPackage>& installed,
    const ParameterFiles& parameter_files, const LeftOutChains& left_out = {});

}  // namespace ros2wasm
