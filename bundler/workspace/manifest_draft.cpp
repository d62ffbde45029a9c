// See manifest_draft.hpp.
#include "bundler/workspace/manifest_draft.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "bundler/workspace/bringup_file.hpp"
#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/base/replaced_text.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ';';
}

struct CMakeCommand {
  std::string name;  ///< lower case
  std::vector<std::string> words;
};

/// Reads commands one after the other: name, then words up to the closing parenthesis.
class CMakeScanner {
 public:
  explicit CMakeScanner(std::string_view text) : text_(text) {}

  std::optional<CMakeCommand> next() {
    std::string name;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        skip_comment();
      } else if (c == '(') {
        ++at_;
        return CMakeCommand{.name = ascii_lower(name), .words = words()};
      } else {
        ++at_;
        if (c == '\n') name.clear();
        if (!is_space(c)) name += c;
      }
    }
    return std::nullopt;
  }

 private:
  void skip_comment() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  std::string quoted() {
    std::string word;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      word += text_[at_];
    }
    if (at_ < text_.size()) ++at_;
    return word;
  }

  std::vector<std::string> words() {
    std::vector<std::string> result;
    std::string word;
    int depth = 1;
    const auto finish = [&] {
      if (!word.empty()) result.push_back(std::exchange(word, {}));
    };
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        skip_comment();
        continue;
      }
      if (c == '"') {
        word += quoted();
        continue;
      }
      ++at_;
      if (c == '(') ++depth;
      if (c == ')' && --depth == 0) break;
      if (is_space(c)) {
        finish();
      } else {
        word += c;
      }
    }
    finish();
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The targets of `install(TARGETS a b ... DESTINATION lib/x)`; none when they do not go below
/// lib/.
std::vector<std::string> installed_targets(const CMakeCommand& command) {
  constexpr std::string_view kEnds[] = {"EXPORT",  "ARCHIVE", "LIBRARY",     "RUNTIME",
                                        "OBJECTS", "BUNDLE",  "DESTINATION", "INCLUDES"};
  if (command.words.empty() || command.words.front() != "TARGETS") return {};
  const auto first = command.words.begin() + 1;
  const auto last = std::find_if(first, command.words.end(), [&](const std::string& word) {
    return std::find(std::begin(kEnds), std::end(kEnds), word) != std::end(kEnds);
  });
  const bool below_lib = std::any_of(
      last, command.words.end(), [](const std::string& word) { return word.starts_with("lib/"); });
  return below_lib ? std::vector<std::string>(first, last) : std::vector<std::string>();
}

/// The names of `install(PROGRAMS a.py ... DESTINATION lib/x)`.
std::vector<std::string> installed_scripts(const CMakeCommand& command) {
  const auto& words = command.words;
  if (words.empty() || words.front() != "PROGRAMS") return {};
  const auto end = std::find(words.begin(), words.end(), "DESTINATION");
  if (end == words.end() || end + 1 == words.end() || !(end + 1)->starts_with("lib/")) return {};
  std::vector<std::string> names;
  for (auto word = words.begin() + 1; word != end; ++word)
    names.push_back(word->substr(word->rfind('/') + 1));
  return names;
}

/// As a YAML scalar: plain when that is surely read back as this text.
std::string yaml_text(const std::string& text) {
  const auto safe = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-' || c == '.' ||
           c == '/' || (c >= '0' && c <= '9') || c == ' ';
  };
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), safe) &&
                     ((text[0] >= 'a' && text[0] <= 'z') || (text[0] >= 'A' && text[0] <= 'Z')) &&
                     text.back() != ' ';
  constexpr std::string_view kWords[] = {"true", "false", "yes", "no", "on",
                                         "off",  "null",  "y",   "n"};
  const bool word =
      std::find(std::begin(kWords), std::end(kWords), ascii_lower(text)) != std::end(kWords);
  return plain && !word ? text : json_quoted(text);
}

/// The value that all packages agree on, or nothing.
std::string agreed(const std::vector<DraftPackage>& packages, std::string DraftPackage::*member) {
  if (packages.empty()) return {};
  const std::string& first = packages.front().*member;
  const bool same = std::all_of(packages.begin(), packages.end(),
                                [&](const DraftPackage& each) { return each.*member == first; });
  return same ? first : std::string();
}

/// `src` when all packages lie below it, so that new ones are found; else each folder.
std::vector<std::string> package_entries(const std::vector<DraftPackage>& packages) {
  const bool all_in_src = std::all_of(packages.begin(), packages.end(), [](const auto& package) {
    return package.folder.starts_with("src/");
  });
  if (all_in_src) return {"src"};
  std::vector<std::string> folders;
  folders.reserve(packages.size());
  for (const DraftPackage& package : packages) folders.push_back(package.folder);
  return folders;
}

std::string list_section(const std::string& key, const std::vector<std::string>& entries) {
  if (entries.empty()) return {};
  std::string text = "\n" + key + ":\n";
  for (const std::string& entry : entries) text += "  - " + yaml_text(entry) + "\n";
  return text;
}

std::string launch_section(const DraftInput& input) {
  const BringupChoice choice = bringup_file(input.launch_files);
  if (!choice.file.empty()) {
    std::string text =
        "# What runs: a launch file; or a list of nodes, each with package and executable.\n";
    for (const std::string& file : choice.candidates) text += "# Another one: " + file + "\n";
    return text + "launch: " + yaml_text(choice.file) + "\n";
  }
  std::string nodes;
  for (const DraftPackage& package : input.packages) {
    for (const std::string& program : package.programs) {
      nodes += "  - package: " + yaml_text(package.name) + "\n";
      nodes += "    executable: " + yaml_text(program) + "\n";
    }
  }
  std::string text;
  if (!input.launch_files.empty()) {
    text += "# Instead of a list, `launch:` may name one of the workspace's launch files:\n";
    for (const std::string& file : input.launch_files) text += "#   launch: " + file + "\n";
  }
  if (nodes.empty()) {
    return text + "# What runs: put in the names of a package and of its program.\nlaunch:\n" +
           "  - package: my_package\n    executable: my_program\n";
  }
  return text + "# What runs: each program once. Take out what should not; a node may also have\n" +
         "# name, namespace, remappings, parameters and arguments.\nlaunch:\n" + nodes;
}

/// The quoted texts from `at` to the closing bracket.
std::vector<std::string> quoted_texts(std::string_view text, std::size_t at) {
  std::vector<std::string> result;
  while (at < text.size() && text[at] != ']') {
    const char c = text[at];
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else if (c == '\'' || c == '"') {
      const auto end = text.find(c, at + 1);
      if (end == std::string_view::npos) break;
      result.emplace_back(text.substr(at + 1, end - at - 1));
      at = end + 1;
    } else {
      ++at;
    }
  }
  return result;
}

std::string name_before_equals(std::string_view line) {
  const auto equals = line.find('=');
  return equals == std::string_view::npos ? std::string()
                                          : std::string(trimmed(line.substr(0, equals)));
}

}  // namespace

std::vector<std::string> console_script_names(std::string_view setup_py,
                                              std::string_view setup_cfg) {
  constexpr std::string_view kGroup = "console_scripts";
  std::set<std::string> names;
  if (const auto group = setup_py.find(kGroup); group != std::string_view::npos) {
    const auto open = setup_py.find('[', group);
    if (open != std::string_view::npos) {
      for (const std::string& entry : quoted_texts(setup_py, open + 1))
        names.insert(name_before_equals(entry));
    }
  }
  if (const auto group = setup_cfg.find(kGroup); group != std::string_view::npos) {
    std::size_t at = setup_cfg.find('\n', group);
    while (at != std::string_view::npos && at + 1 < setup_cfg.size() &&
           (setup_cfg[at + 1] == ' ' || setup_cfg[at + 1] == '\t')) {
      const std::size_t end = std::min(setup_cfg.find('\n', at + 1), setup_cfg.size());
      names.insert(name_before_equals(setup_cfg.substr(at + 1, end - at - 1)));
      at = end == setup_cfg.size() ? std::string_view::npos : end;
    }
  }
  names.erase(std::string());
  return {names.begin(), names.end()};
}

std::vector<std::string> installed_program_names(std::string_view cmake_lists) {
  std::string project;
  std::set<std::string> made;
  std::set<std::string> installed;
  std::set<std::string> programs;
  CMakeScanner scanner(cmake_lists);
  while (auto command = scanner.next()) {
    for (std::string& word : command->words) {
      if (!project.empty()) word = with_replaced(word, "${PROJECT_NAME}", project);
    }
    const auto& words = command->words;
    if (words.empty()) continue;
    if (command->name == "project") {
      project = words.front();
    } else if (command->name == "add_executable") {
      made.insert(words.front());
    } else if (command->name == "install") {
      for (const std::string& target : installed_targets(*command)) installed.insert(target);
      for (const std::string& script : installed_scripts(*command)) programs.insert(script);
    } else if (command->name == "rclcpp_components_register_node") {
      const auto option = std::find(words.begin(), words.end(), "EXECUTABLE");
      if (option != words.end() && option + 1 != words.end()) programs.insert(*(option + 1));
    }
  }
  std::set_intersection(made.begin(), made.end(), installed.begin(), installed.end(),
                        std::inserter(programs, programs.end()));
  std::erase_if(programs,
                [](const std::string& name) { return name.find('$') != std::string::npos; });
  return {programs.begin(), programs.end()};
}

std::string draft_manifest(const DraftInput& input) {
  std::string version = agreed(input.packages, &DraftPackage::version);
  if (version.empty()) version = "0.1.0";
  const std::string license = agreed(input.packages, &DraftPackage::license);
  std::string text = "# Written by `ros2wasm init`; `ros2wasm pack` turns it into a site.\n";
  text += "schema: 1\n";
  text += "name: " + yaml_text(input.name) + "\n";
  text += "title: " + yaml_text(input.title) + "\n";
  text += "version: " + json_quoted(version) + "\n";
  if (!license.empty()) text += "license: " + yaml_text(license) + "\n";
  text += "distro: jazzy\n";
  std::vector<std::string> folders;
  if (!input.packages.empty()) folders = package_entries(input.packages);
  text += list_section("packages", folders) + list_section("channels", input.channels) +
          list_section("dependencies", input.dependencies);
  text += "\n" + launch_section(input);
  return text;
}

}  // namespace ros2wasm
