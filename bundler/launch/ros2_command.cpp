// See ros2_command.hpp.
#include "bundler/launch/ros2_command.hpp"

#include <algorithm>

namespace ros2wasm {
namespace {

struct Ros2Verb {
  std::string_view group;
  std::string_view verb;
};

/// Those of runtime/site/ros2cli/table.ts, sorted; tests/unit/ros2cli/launched_commands.test.ts
/// compares them.
constexpr Ros2Verb kRos2Verbs[] = {
    {"action", "info"},
    {"action", "list"},
    {"action", "send_goal"},
    {"action", "type"},
    {"bag", "info"},
    {"bag", "play"},
    {"bag", "record"},
    {"component", "list"},
    {"component", "load"},
    {"component", "unload"},
    {"control", "cleanup_controller"},
    {"control", "list_controller_types"},
    {"control", "list_controllers"},
    {"control", "list_hardware_components"},
    {"control", "list_hardware_interfaces"},
    {"control", "load_controller"},
    {"control", "reload_controller_libraries"},
    {"control", "set_controller_state"},
    {"control", "set_hardware_component_state"},
    {"control", "switch_controllers"},
    {"control", "unload_controller"},
    {"daemon", "start"},
    {"daemon", "status"},
    {"daemon", "stop"},
    {"interface", "list"},
    {"interface", "package"},
    {"interface", "packages"},
    {"interface", "proto"},
    {"interface", "show"},
    {"lifecycle", "get"},
    {"lifecycle", "list"},
    {"lifecycle", "nodes"},
    {"lifecycle", "set"},
    {"node", "info"},
    {"node", "list"},
    {"param", "delete"},
    {"param", "describe"},
    {"param", "dump"},
    {"param", "get"},
    {"param", "list"},
    {"param", "load"},
    {"param", "set"},
    {"pkg", "create"},
    {"pkg", "executables"},
    {"pkg", "list"},
    {"pkg", "prefix"},
    {"pkg", "xml"},
    {"service", "call"},
    {"service", "echo"},
    {"service", "find"},
    {"service", "info"},
    {"service", "list"},
    {"service", "type"},
    {"topic", "bw"},
    {"topic", "delay"},
    {"topic", "echo"},
    {"topic", "find"},
    {"topic", "hz"},
    {"topic", "info"},
    {"topic", "list"},
    {"topic", "pub"},
    {"topic", "type"},
};

constexpr std::string_view kNoPrograms = "a site runs nodes of packages and commands of ros2 only";

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

}  // namespace

bool names_program(std::string_view word, std::string_view program) {
  return word == program || (word.ends_with(program) && word.size() > program.size() &&
                             word[word.size() - program.size() - 1] == '/');
}

bool runs_in_site(const std::vector<std::string>& words) {
  if (words.size() < 3 || !names_program(words[0], "ros2")) return false;
  return std::any_of(std::begin(kRos2Verbs), std::end(kRos2Verbs), [&](const Ros2Verb& one) {
    return words[1] == one.group && words[2] == one.verb;
  });
}

std::optional<std::vector<std::string>> shell_words(std::string_view line) {
  std::vector<std::string> words;
  std::string word;
  bool begun = false;
  char quote = '\0';
  const auto end = [&] {
    if (begun) words.push_back(std::move(word));
    word.clear();
    begun = false;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const char next = i + 1 < line.size() ? line[i + 1] : '\0';
    if (quote == '\'') {
      if (c == quote) {
        quote = '\0';
      } else {
        word += c;
      }
    } else if (c == '$' || c == '`') {
      return std::nullopt;
    } else if (quote == '"') {
      if (c == quote) {
        quote = '\0';
      } else if (c == '\\' && std::string_view("\"\\$`").find(next) != std::string_view::npos &&
                 next != '\0') {
        word += next;
        ++i;
      } else {
        word += c;
      }
    } else if (c == '\'' || c == '"') {
      quote = c;
      begun = true;
    } else if (is_blank(c)) {
      end();
    } else if (c == '#' && !begun) {
      break;  // the rest of the line is a remark
    } else if (std::string_view("|&;<>()\n").find(c) != std::string_view::npos ||
               (c == '~' && !begun)) {
      return std::nullopt;
    } else {
      const bool is_escaped = c == '\\' && next != '\0';
      if (is_escaped) ++i;
      word += is_escaped ? next : c;
      begun = true;
    }
  }
  if (quote != '\0') return std::nullopt;
  end();
  return words;
}

std::string shown_command(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    const bool is_plain =
        !word.empty() && word.find_first_of(" \t\r\n'\"\\|&;<>()$`#~*?") == std::string::npos;
    if (is_plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

std::string_view instead_of_command(const std::vector<std::string>& words) {
  if (words.size() < 2 || !names_program(words[0], "ros2")) return kNoPrograms;
  if (words[1] == "launch") return "include the launch file";
  return "of ros2 a site has no such command";
}

}  // namespace ros2wasm
