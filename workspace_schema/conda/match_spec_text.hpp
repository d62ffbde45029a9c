// The pieces that the text of a match spec is taken apart into. Pure; only for match_spec.cpp and
// its tests.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// A platform that conda knows.
[[nodiscard]] bool known_subdir(std::string_view text);

/// Takes the last "(...)" or "[...]" out of `text`, wherever it stands, and returns what is inside;
/// nothing when there is none.
[[nodiscard]] std::optional<std::string> take_section(std::string& text, char open, char close);

struct BracketPair {
  std::string key;
  std::string value;
};

/// All `key=value` of a bracket section; what is none of them is passed over, as conda does.
[[nodiscard]] std::vector<BracketPair> bracket_pairs(std::string_view text);

/// "=1.2" -> "1.2.*", "==1.2" -> "1.2": conda's way to write fuzzy and exact.
[[nodiscard]] std::string normal_version(const std::string& version, bool has_build);

/// One space in place of several behind a sign of comparison or a comma, where conda would take
/// what follows for a build string.
[[nodiscard]] std::string with_single_spaces(std::string_view text);

/// The digits of what Python's `int` reads as a number that is not negative: "+1", "1_000".
[[nodiscard]] std::optional<std::string> whole_number(std::string_view text);

struct VersionAndBuild {
  std::string version;
  std::optional<std::string> build;
};

/// The first space or `=` behind which only a build string can stand parts the two.
[[nodiscard]] VersionAndBuild part_version_and_build(std::string_view text);

/// CEP 26: letters, digits and single separators; `_` or `__` may stand in front.
[[nodiscard]] bool is_package_name(std::string_view name);

/// The part after the last slash.
[[nodiscard]] std::string_view last_part(std::string_view path);

/// Ends as archives do.
[[nodiscard]] bool is_archive_name(std::string_view text);

}  // namespace ros2wasm
