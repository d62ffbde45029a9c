// Commands of `ros2` that launch files start as processes: which of them a site runs, and the words
// of a line that is for a shell. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// Whether the word is the program's name, or a path that ends with it.
[[nodiscard]] bool names_program(std::string_view word, std::string_view program);

/// Whether a site runs it by itself: `ros2 topic echo /chatter`. `ros2 run` starts a node, and is
/// none; nor is `ros2 launch`.
[[nodiscard]] bool runs_in_site(const std::vector<std::string>& words);

/// The words that a shell makes of a line; none when it does more than start one program: pipes,
/// redirections, variables, several commands, or a quote that is left open.
[[nodiscard]] std::optional<std::vector<std::string>> shell_words(std::string_view line);

/// For people: a line that a shell would split into these words.
[[nodiscard]] std::string shown_command(const std::vector<std::string>& words);

/// The replacement for a command that no site runs, as the end of a sentence.
[[nodiscard]] std::string_view instead_of_command(const std::vector<std::string>& words);

}  // namespace ros2wasm
