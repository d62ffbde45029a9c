// See launch_packages.hpp.
#include "bundler/workspace/launch_packages.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

#include "workspace_schema/base/source_text.hpp"

namespace ros2wasm {
namespace {

/// The text between a word and the name of a package.
enum class Form {
  kAssigned,  ///< `=` and a quote, or `:`
  kCalled,    ///< `(` and a quote
  kSpaced,    ///< a space
};

struct Word {
  std::string_view text;
  Form form;
};

constexpr auto kWords = std::to_array<Word>({
    {"package", Form::kAssigned},
    {"pkg", Form::kAssigned},
    {"FindPackagePrefix", Form::kCalled},
    {"FindPackageShare", Form::kCalled},
    {"get_package_prefix", Form::kCalled},
    {"get_package_share_directory", Form::kCalled},
    {"get_package_share_path", Form::kCalled},
    {"find-pkg-prefix", Form::kSpaced},
    {"find-pkg-share", Form::kSpaced},
});

constexpr auto kEndings = std::to_array<std::string_view>(
    {"launch.py", "launch.xml", "launch.yaml", "launch.yml", ".launch"});

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

bool is_quote(char c) {
  return c == '\'' || c == '"';
}

/// Comments become blanks, so that all else keeps its place.
std::string without_comments(std::string text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::size_t first = text.find_first_not_of(" \t", at);
    if (first < end && text[first] == '#')
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(first),
                text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    at = end + 1;
  }
  for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at)) {
    const std::size_t end = std::min(text.find("-->", at), text.size());
    for (; at < end; ++at) {
      if (text[at] != '\n') text[at] = ' ';
    }
  }
  return text;
}

/// Reads on from `at`, over spaces and, in brackets, over lines.
void skip_spaces(std::string_view text, std::size_t& at, bool lines) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || (lines && text[at] == '\n')))
    ++at;
}

bool skip_one(std::string_view text, std::size_t& at, bool (*fits)(char)) {
  if (at >= text.size() || !fits(text[at])) return false;
  ++at;
  return true;
}

/// From behind the word to the name; false when something else stands there.
bool skip_to_name(std::string_view text, std::size_t& at, Form form) {
  switch (form) {
    case Form::kAssigned: {
      skip_one(text, at, is_quote);  // of a key in quotes
      skip_spaces(text, at, false);
      const bool of_yaml = at < text.size() && text[at] == ':';
      if (!skip_one(text, at, [](char c) { return c == '=' || c == ':'; })) return false;
      skip_spaces(text, at, false);
      return skip_one(text, at, is_quote) || of_yaml;
    }
    case Form::kCalled:
      skip_spaces(text, at, false);
      if (!skip_one(text, at, [](char c) { return c == '('; })) return false;
      skip_spaces(text, at, true);
      return skip_one(text, at, is_quote);
    case Form::kSpaced:
      skip_spaces(text, at, false);
      return at < text.size() && text[at - 1] == ' ';
  }
  return false;
}

/// Reads `cmd=[...]` from behind `cmd`: the name of a program of Gazebo, as a part of `code`, if it
/// starts Gazebo. Whatever finds the program may be before its name: `ruby $(which gz) sim`.
std::optional<std::string_view> program_of_gazebo(std::string_view code, std::size_t at) {
  constexpr std::size_t kMostWords = 8;
  skip_one(code, at, is_quote);
  skip_spaces(code, at, false);
  if (!skip_one(code, at, [](char c) { return c == '=' || c == ':'; })) return std::nullopt;
  std::optional<std::string_view> program;
  for (std::size_t i = 0; i < kMostWords; ++i) {
    while (at < code.size() && !is_letter(code[at])) ++at;
    const std::size_t start = at;
    while (at < code.size() && is_letter(code[at])) ++at;
    const std::string_view word = code.substr(start, at - start);
    if (program) {
      if (word == "sim" || word == "gazebo") return program;
      return std::nullopt;
    }
    if (word == "gazebo" || word == "gzserver" || word == "gzclient") return word;
    if (word == "gz" || word == "ign") {
      program = word;
    } else if (word != "FindExecutable" && word != "name" && word != "ruby" && word != "which" &&
               word != "usr" && word != "bin" && word != "find-exec") {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

bool is_launch_file_name(std::string_view name) {
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

std::vector<Spanned<std::string>> launch_packages(std::string_view text, const std::string& file) {
  const std::string code = without_comments(std::string(text));
  const SourceText source(text, file);
  std::set<std::string> known;
  std::vector<Spanned<std::string>> found;
  for (std::size_t at = 0; at < code.size();) {
    if (!is_letter(code[at])) {
      ++at;
      continue;
    }
    const std::size_t start = at;
    while (at < code.size() && is_letter(code[at])) ++at;
    const std::string_view word = std::string_view(code).substr(start, at - start);
    if (word == "cmd") {
      const auto program = program_of_gazebo(code, at);
      if (program && known.insert(std::string(kSimulatorPackage)).second)
        found.push_back(
            {.value = std::string(kSimulatorPackage),
             .span = source.span(static_cast<std::size_t>(program->data() - code.data()),
                                 program->size())});
      continue;
    }
    const auto* row = std::find_if(kWords.begin(), kWords.end(),
                                   [&](const Word& one) { return one.text == word; });
    if (row == kWords.end() || !skip_to_name(code, at, row->form)) continue;
    const std::size_t place = at;
    while (at < code.size() && is_letter(code[at])) ++at;
    const std::string name = code.substr(place, at - place);
    if (name.empty() || !known.insert(name).second) continue;
    found.push_back({.value = name, .span = source.span(place, name.size())});
  }
  return found;
}

bool is_description_name(std::string_view name) {
  constexpr auto kDescriptions =
      std::to_array<std::string_view>({".urdf", ".xacro", ".sdf", ".world"});
  return std::any_of(kDescriptions.begin(), kDescriptions.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

std::vector<Spanned<std::string>> description_packages(std::string_view text,
                                                       const std::string& file) {
  struct Library {
    std::string_view name, package;
  };
  constexpr auto kLibraries =
      std::to_array<Library>({{"libgazebo_ros2_control", "gazebo_ros2_control"},
                              {"gz_ros2_control-system", "gz_ros2_control"},
                              {"ign_ros2_control-system", "ign_ros2_control"}});
  const std::string code = without_comments(std::string(text));
  std::vector<Spanned<std::string>> found;
  for (const Library& library : kLibraries) {
    const std::size_t at = code.find(library.name);
    if (at == std::string::npos) continue;
    found.push_back({.value = std::string(library.package),
                     .span = SourceText(std::string(text), file).span(at, library.name.size())});
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.span.line < b.span.line; });
  return found;
}

}  // namespace ros2wasm
