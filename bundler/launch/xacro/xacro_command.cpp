// See xacro.hpp: the command line of xacro.
#include <utility>
#include <vector>

#include "bundler/launch/xacro/xacro.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

using Words = std::vector<std::string>;

/// As a shell splits a line: at white space outside of quotes. Nothing when a quote stays open.
std::optional<Words> words_of(const std::string& line) {
  Words result;
  std::string word;
  bool inside = false;
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (quote != '\0' ? c == quote : c == '\'' || c == '"') {
      quote = quote == '\0' ? c : '\0';
      inside = true;
    } else if (c == '\\' && quote != '\'' && i + 1 < line.size()) {
      word += line[++i];
      inside = true;
    } else if (space && quote == '\0') {
      if (inside) result.push_back(std::exchange(word, {}));
      inside = false;
    } else {
      word += c;
      inside = true;
    }
  }
  if (quote != '\0') return std::nullopt;
  if (inside) result.push_back(word);
  return result;
}

/// How many words name the program; 0 when it is another.
std::size_t program_words(const Words& words) {
  if (!words.empty() && (words[0] == "xacro" || words[0].ends_with("/xacro"))) return 1;
  const bool run = words.size() >= 4 && words[0] == "ros2" && words[1] == "run" &&
                   words[2] == "xacro" && words[3] == "xacro";
  return run ? 4 : 0;
}

Diagnostic refused(std::string message, const std::string& line, const SourceSpan& span) {
  return {
      .code = "R2W0418",
      .message = std::move(message),
      .span = span,
      .why = {"the command is: " + line, "xacro takes a file, and NAME:=VALUE for its arguments"}};
}

/// How much xacro says while it works, which changes nothing.
bool is_quiet_option(const std::string& word) {
  return word == "-q" || word == "-v" || word == "-i" || word == "--inorder" ||
         word.starts_with("--verbosity=");
}

}  // namespace

std::optional<Outcome<XacroRequest>> xacro_command(const std::string& line,
                                                   const std::string& directory,
                                                   const SourceSpan& span) {
  const auto words = words_of(line);
  if (!words) return std::nullopt;
  const std::size_t begin = program_words(*words);
  if (begin == 0) return std::nullopt;
  XacroRequest request{.directory = directory};
  for (std::size_t i = begin; i < words->size(); ++i) {
    const std::string& word = (*words)[i];
    if (const std::size_t at = word.find(":="); at != std::string::npos) {
      const std::string name(trimmed(std::string_view(word).substr(0, at)));
      const std::string value(trimmed(std::string_view(word).substr(at + 2)));
      if (!name.empty() && !value.empty()) request.arguments[name] = value;
    } else if (word == "--verbosity" && i + 1 < words->size()) {
      ++i;
    } else if (is_quiet_option(word)) {
      continue;
    } else if (word.starts_with('-')) {
      return refused("`xacro` has no option `" + word + "` here", line, span);
    } else if (!request.path.empty()) {
      return refused("`xacro` expands one file, found a second: `" + word + "`", line, span);
    } else {
      request.path = word;
    }
  }
  if (request.path.empty()) return refused("`xacro` needs a file to expand", line, span);
  if (!request.path.starts_with('/')) request.path = directory + "/" + request.path;
  return request;
}

std::optional<std::string> cat_command(const std::string& line, const std::string& directory) {
  const auto words = words_of(line);
  if (!words || words->size() != 2 || (*words)[1].starts_with('-')) return std::nullopt;
  if ((*words)[0] != "cat" && !(*words)[0].ends_with("/cat")) return std::nullopt;
  const std::string& file = (*words)[1];
  return file.starts_with('/') ? file : directory + "/" + file;
}

}  // namespace ros2wasm
