// Names of nodes, namespaces, topics and services: what is valid, and how short forms expand.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// Why a name is refused: text for people and the place of the first wrong character.
struct NameProblem {
  const char* message;
  size_t index;
};

std::optional<NameProblem> check_node_name(std::string_view name);
/// An absolute namespace, "/" or "/a/b".
std::optional<NameProblem> check_namespace(std::string_view ns);
/// A name as a program writes it: relative, private ("~/x") or absolute, with {substitutions}.
std::optional<NameProblem> check_topic_name(std::string_view name);
/// A name after expansion.
std::optional<NameProblem> check_full_topic_name(std::string_view name);
/// Absolute name of `name`, which must be valid; empty for an unknown {substitution}.
std::string expand_topic_name(std::string_view name, std::string_view node, std::string_view ns);
/// "/" + "talker" or "/ns" + "talker".
std::string join_name(std::string_view ns, std::string_view name);

}  // namespace ros2wasm
