// See environment_hooks.hpp.
#include "bundler/workspace/environment_hooks.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

using Variables = std::map<std::string, std::string>;

/// A site has programs, libraries and modules of packages at places of its own.
constexpr std::array<std::string_view, 9> kOfTheSite = {
    "AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", "COLCON_PREFIX_PATH",
    "DYLD_LIBRARY_PATH", "LD_LIBRARY_PATH",   "PATH",
    "PKG_CONFIG_PATH",   "PYTHONPATH",        "ROS_PACKAGE_PATH"};
constexpr std::array<std::string_view, 2> kFolders = {"environment", "hook"};

bool is_of_the_site(const std::string& name) {
  return std::find(kOfTheSite.begin(), kOfTheSite.end(), name) != kOfTheSite.end();
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

/// Adds a folder to a list between colons, unless it is there.
void add(Variables& variables, const std::string& name, const std::string& value, bool in_front) {
  std::string& list = variables[name];
  const std::vector<std::string> there = split(list, ':');
  if (std::find(there.begin(), there.end(), value) != there.end()) return;
  if (list.empty())
    list = value;
  else
    list = in_front ? value + ":" + list : list + ":" + value;
}

/// `prepend-non-duplicate;GAZEBO_MODEL_PATH;share/demo/models`
void apply_list(const std::string& text, const std::string& prefix, const HasPath& has,
                Variables& variables) {
  for (std::string line : split(text, '\n')) {
    if (line.ends_with('\r')) line.pop_back();
    const std::vector<std::string> words = split(line, ';');
    if (words.size() < 2 || is_of_the_site(words[1])) continue;
    const std::string& kind = words[0];
    const std::string& name = words[1];
    if (kind == "set" || (kind == "set-if-unset" && !variables.contains(name))) {
      const std::string value = words.size() > 2 ? words[2] : "";
      variables[name] =
          value.empty() || has(value) ? prefix + (value.empty() ? "" : "/" + value) : value;
      continue;
    }
    const bool in_front = kind.starts_with("prepend-non-duplicate");
    if (!in_front && !kind.starts_with("append-non-duplicate")) continue;
    for (std::size_t i = 2; i < std::max<std::size_t>(words.size(), 3); ++i) {
      const std::string value = i < words.size() ? words[i] : "";
      if (kind.ends_with("-if-exists") && !has(value)) continue;
      const bool is_absolute = value.starts_with('/');
      add(variables, name, is_absolute ? value : prefix + (value.empty() ? "" : "/" + value),
          in_front);
    }
  }
}

/// Without the quotes around it, and with the variables that a hook has. Nothing for words that
/// need a shell.
std::optional<std::string> expanded(std::string word, const std::string& prefix,
                                    const Variables& variables) {
  std::erase(word, '"');
  std::string result;
  for (std::size_t at = 0; at < word.size();) {
    if (word[at] == '`' || word[at] == '\'' || word[at] == ' ') return std::nullopt;
    if (word[at] != '$') {
      result += word[at++];
      continue;
    }
    const bool has_braces = at + 1 < word.size() && word[at + 1] == '{';
    const std::size_t first = at + (has_braces ? 2 : 1);
    std::size_t end = first;
    while (end < word.size() &&
           (std::isalnum(static_cast<unsigned char>(word[end])) != 0 || word[end] == '_'))
      ++end;
    const std::string name = word.substr(first, end - first);
    if (name.empty() || (has_braces && (end == word.size() || word[end] != '}')))
      return std::nullopt;
    const auto known = variables.find(name);
    if (name == "AMENT_CURRENT_PREFIX" || name == "COLCON_CURRENT_PREFIX")
      result += prefix;
    else if (known != variables.end())
      result += known->second;
    at = end + (has_braces ? 1 : 0);
  }
  return result;
}

/// `ament_prepend_unique_value NAME "$AMENT_CURRENT_PREFIX/share/demo"` and `export NAME=value`;
/// what else a shell could do is passed over.
void apply_script(const std::string& text, const std::string& prefix, Variables& variables) {
  for (const std::string& line : split(text, '\n')) {
    std::istringstream stream(line);
    std::string command;
    std::string name;
    std::string value;
    stream >> command >> name;
    const bool in_front =
        command == "ament_prepend_unique_value" || command == "colcon_prepend_unique_value";
    if (command == "export") {
      const std::size_t equals = name.find('=');
      if (equals == std::string::npos) continue;
      value = name.substr(equals + 1);
      name.resize(equals);
    } else if (in_front || command == "ament_append_unique_value") {
      stream >> value;
    } else {
      continue;
    }
    const auto whole = expanded(value, prefix, variables);
    if (!whole || name.empty() || is_of_the_site(name)) continue;
    if (command == "export")
      variables[name] = *whole;
    else
      add(variables, name, *whole, in_front);
  }
}

}  // namespace

void apply_hook(const EnvironmentHook& hook, const std::string& prefix, const HasPath& has,
                Variables& variables) {
  if (hook.is_list)
    apply_list(hook.text, prefix, has, variables);
  else
    apply_script(hook.text, prefix, variables);
}

Variables with_environment_hooks(Variables variables, const std::vector<InstalledPackage>& packages,
                                 const std::string& prefix) {
  for (const InstalledPackage& package : packages) {
    const HasPath has = [&](const std::string& path) {
      std::error_code error;
      return fs::exists(package.prefix / path, error);
    };
    std::set<fs::path> hooks;
    for (const std::string_view folder : kFolders) {
      std::error_code error;
      for (fs::directory_iterator it(package.prefix / "share" / package.name / folder, error), end;
           !error && it != end; it.increment(error))
        hooks.insert(it->path());
    }
    for (const fs::path& hook : hooks) {
      fs::path list = hook;
      list.replace_extension(".dsv");
      const bool is_list = hook == list;
      // A shell script says the same as the list beside it.
      if (!is_list && (hook.extension() != ".sh" || hooks.contains(list))) continue;
      if (const auto text = read_file(hook, kMostOfList))
        apply_hook({.text = *text, .is_list = is_list}, prefix, has, variables);
    }
  }
  return variables;
}

}  // namespace ros2wasm
