// See cmake_packages.hpp.
#include "bundler/workspace/cmake_packages.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "workspace_schema/base/source_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kCommand = "find_package";
constexpr std::string_view kRequired = "REQUIRED";
/// Commands that fail when a package that they name was not found.
constexpr std::array<std::string_view, 3> kNeeding = {
    "ament_export_dependencies", "ament_target_dependencies", "rosidl_generate_interfaces"};

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '+' ||
         c == '.';
}

/// Comments become blanks, so that all else keeps its place.
std::string without_comments(std::string text) {
  for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#', at)) {
    std::size_t end = text.find('\n', at);
    if (text.compare(at, 3, "#[[") == 0) {
      end = text.find("]]", at);
      if (end != std::string::npos) end += 2;
    }
    end = std::min(end, text.size());
    for (; at < end; ++at) {
      if (text[at] != '\n') text[at] = ' ';
    }
  }
  return text;
}

/// A command with its arguments, as CMake sees them: words, quotes as they are.
using Words = std::vector<std::pair<std::string, std::size_t>>;  ///< each with its place
struct Command {
  std::string name;  ///< in small letters
  Words words;
};

/// The command that starts at `at`, which then stands behind it; none: `at` stands behind the word.
std::optional<Command> read_command(std::string_view text, std::size_t& at) {
  Command command;
  for (; at < text.size() && is_name_character(text[at]); ++at)
    command.name += static_cast<char>(std::tolower(static_cast<unsigned char>(text[at])));
  const std::size_t open = text.find_first_not_of(" \t\r", at);
  if (open == std::string_view::npos || text[open] != '(') return std::nullopt;
  std::size_t depth = 1;
  std::string word;
  for (at = open + 1; at < text.size() && depth > 0; ++at) {
    const char c = text[at];
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    const bool ends = depth == 0 || std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!ends) word += c;
    if (ends && !word.empty()) {
      command.words.emplace_back(word, at - word.size());
      word.clear();
    }
  }
  return command;
}

/// Variables that hold what is written in the file, as far as set(), list(APPEND) and foreach()
/// over such tell: a foreach()'s own has all its values at once. When a file has used up
/// kMostCopied, the variables keep the values that they have.
class Variables {
 public:
  void follow(const Command& command) {
    const Words& words = command.words;
    if (words.empty()) return;
    if (command.name == "set") values_[words[0].first] = expanded(words, 1);
    if (command.name == "foreach") loop(words);
    if (command.name == "list" && words.size() > 1 && words[0].first == "APPEND") {
      const Words more = expanded(words, 2);
      add(more, values_[words[1].first]);
    }
  }

  /// The words from `first` on, with known variables replaced by their values; an unknown variable
  /// stays as it is.
  [[nodiscard]] Words expanded(const Words& words, std::size_t first) {
    Words result;
    for (; first < words.size(); ++first) {
      const std::string& word = words[first].first;
      const auto found = word.starts_with("${") && word.ends_with("}")
                             ? values_.find(word.substr(2, word.size() - 3))
                             : values_.end();
      if (found == values_.end())
        result.push_back(words[first]);
      else
        add(found->second, result);
    }
    return result;
  }

 private:
  /// More than any list of packages has.
  static constexpr std::size_t kMostValues = 1000;
  /// Values that may be copied for one file, in total: lists of lists grow without end.
  static constexpr std::size_t kMostCopied = 200'000;

  /// Appends what fits.
  void add(const Words& more, Words& list) {
    const std::size_t room = kMostValues - std::min(kMostValues, list.size());
    const std::size_t count = std::min({more.size(), room, kMostCopied - copied_});
    list.insert(list.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(count));
    copied_ += count;
  }

  void loop(const Words& words) {
    const bool has_in = words.size() > 2 && words[1].first == "IN";
    if (!has_in || words[2].first != "LISTS") {
      values_[words[0].first] = expanded(words, has_in ? 3 : 1);
      return;
    }
    Words all;
    for (std::size_t i = 3; i < words.size(); ++i) {
      const auto list = values_.find(words[i].first);
      if (list != values_.end()) add(list->second, all);
    }
    values_[words[0].first] = std::move(all);
  }

  std::map<std::string, Words> values_;
  std::size_t copied_ = 0;
};

/// The next command from `at` on, which becomes the place behind it.
std::optional<Command> next_command(const std::string& code, std::size_t& at) {
  while (at < code.size()) {
    if (!is_name_character(code[at])) {
      ++at;
    } else if (auto command = read_command(code, at)) {
      return command;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Spanned<std::string>> cmake_packages(std::string_view text, const std::string& file) {
  const std::string code = without_comments(std::string(text));
  struct Asked {
    std::string name;
    std::size_t place;
    bool is_required;
  };
  std::vector<Asked> asked;
  std::set<std::string> needed;  // by commands that fail without
  Variables variables;
  int inside = 0;
  std::size_t at = 0;
  while (const auto command = next_command(code, at)) {
    inside += command->name == "if" ? 1 : command->name == "endif" ? -1 : 0;
    if (inside > 0) continue;
    variables.follow(*command);
    if (std::find(kNeeding.begin(), kNeeding.end(), command->name) != kNeeding.end())
      for (const auto& [word, place] : variables.expanded(command->words, 0)) needed.insert(word);
    if (command->name != kCommand || command->words.empty()) continue;
    const bool is_required = std::any_of(command->words.begin(), command->words.end(),
                                         [](const auto& word) { return word.first == kRequired; });
    for (const auto& [name, place] : variables.expanded({command->words.front()}, 0))
      asked.push_back({.name = name, .place = place, .is_required = is_required});
  }
  const SourceText source(text, file);
  std::set<std::string> known;
  std::vector<Spanned<std::string>> found;
  for (const Asked& one : asked) {
    if (!one.is_required && !needed.contains(one.name)) continue;
    if (!std::all_of(one.name.begin(), one.name.end(), is_name_character) ||
        !known.insert(one.name).second)
      continue;
    found.push_back({.value = one.name, .span = source.span(one.place, one.name.size())});
  }
  return found;
}

std::optional<CMakeProject> cmake_project(std::string_view text, const std::string& file) {
  const std::string code = without_comments(std::string(text));
  Variables variables;
  std::size_t at = 0;
  while (const auto command = next_command(code, at)) {
    variables.follow(*command);
    if (command->name != "project") continue;
    const Words words = variables.expanded(command->words, 0);
    if (words.empty()) return std::nullopt;
    auto [name, place] = words.front();
    if (name.size() > 2 && name.starts_with('"') && name.ends_with('"')) {
      name = name.substr(1, name.size() - 2);
      ++place;
    }
    if (!std::all_of(name.begin(), name.end(), is_name_character)) return std::nullopt;
    // It becomes the name of a folder: neither `..`, nor a hidden one, nor an option.
    if (name.empty() || name.front() == '.' || name.front() == '-') return std::nullopt;
    CMakeProject project{
        .name = {.value = name, .span = SourceText(text, file).span(place, name.size())},
        .version = {}};
    for (std::size_t i = 1; i + 1 < words.size(); ++i)
      if (words[i].first == "VERSION") project.version = words[i + 1].first;
    return project;
  }
  return std::nullopt;
}

}  // namespace ros2wasm
