// The command line of a node process, as ros2 launch writes it. Pure.
#pragma once

#include <string>
#include <vector>

#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// A value as YAML on one line, such that reading it gives the same type again: `1.0`, `'1'`,
/// `[true, false]`.
[[nodiscard]] std::string parameter_text(const ParameterValue& value);

/// A parameter of the nodes that `pattern` matches (a name, a full name, or with `*` and `**`;
/// empty: all nodes).
struct ParameterRule {
  std::string pattern;
  std::string name;
  std::string value;  ///< YAML on one line
};

/// The rules in one parameter file, in its order.
using FileRules = std::vector<ParameterRule>;

/// Everything after argv[0]. `files` belong to the entry's parameter_files, one each. Files and
/// single parameters come in the entry's order: later rules win over earlier ones.
[[nodiscard]] std::vector<std::string> node_arguments(const NodeEntry& entry,
                                                      const std::vector<FileRules>& files);

/// `/namespace/name`, or `executable (/namespace)` when the entry does not name the node; of a
/// command the whole line.
[[nodiscard]] std::string node_label(const NodeEntry& entry);

/// `package/executable`; of a command the whole line.
[[nodiscard]] std::string program_label(const NodeEntry& entry);

}  // namespace ros2wasm
