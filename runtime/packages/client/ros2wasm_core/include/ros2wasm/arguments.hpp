// The ROS part of a command line: `--ros-args -r from:=to -p name:=value ... --`.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ros2wasm {

enum class RemapKind { topic, service, topic_and_service, node_name, node_namespace };

/// `[node:]from:=to`. `node` empty: for all nodes.
struct RemapRule {
  RemapKind kind;
  std::string node;
  std::string from;
  std::string to;
};

/// `[node:]name:=value`; the value is YAML text.
struct ParameterRule {
  std::string node;
  std::string name;
  std::string value;
};

/// One `-p` or `--params-file`, in the order given: the later wins.
struct ParameterSource {
  bool is_file;
  std::string file;
  ParameterRule rule;
};

struct Arguments {
  std::vector<RemapRule> remaps;
  std::vector<ParameterSource> parameters;
  /// Logger name (empty: the default level) and severity.
  std::vector<std::pair<std::string, int>> log_levels;
  bool log_stdout = true;
  bool log_rosout = true;
  std::string enclave;
  /// The arguments between --ros-args and -- that are not known.
  std::vector<std::string> unknown_ros_arguments;
  /// Everything outside of --ros-args ... --
  std::vector<std::string> other_arguments;
};

/// Throws std::invalid_argument, with text for people, for a rule that cannot be read.
Arguments parse_arguments(const std::vector<std::string>& arguments);

/// The name after the first rule that fits, local rules first; `name` when none does.
/// `from` and the result are expanded to full names with the node's name and namespace.
std::string remap_topic_or_service(const Arguments* local, const Arguments* global,
                                   const std::string& full_name, bool is_service,
                                   const std::string& node, const std::string& ns);
std::string remap_node_name(const Arguments* local, const Arguments* global,
                            const std::string& name);
std::string remap_node_namespace(const Arguments* local, const Arguments* global,
                                 const std::string& name, const std::string& ns);

}  // namespace ros2wasm
