// See paths_json.hpp.
#include "bundler/archive/paths_json.hpp"

#include <algorithm>
#include <vector>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/link_rules.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {

PathKind kind_of(const std::string& path_type) {
  if (path_type == "softlink") return PathKind::kLink;
  return path_type == "directory" ? PathKind::kDirectory : PathKind::kFile;
}

/// The placeholder of lines in has_prefix that name none.
constexpr const char* kOldPlaceholder = "/opt/anaconda1anaconda2anaconda3";

using Paths = std::map<std::string, PathEntry>;

Outcome<Paths> parse_paths_json(std::string_view text, const std::string& name) {
  const auto json = parse_json(text, "info/paths.json of " + name, "R2W0221");
  if (!json) return json.errors();
  const JsonValue* paths = json->find("paths");
  if (paths == nullptr || !paths->is_array())
    return damaged_archive(name, "info/paths.json has no list `paths`");
  Paths entries;
  for (const JsonValue& item : paths->items()) {
    const std::string written = item.text_of("_path");
    const auto path = safe_member_path(written);
    if (!path) return damaged_archive(name, "info/paths.json names the path `" + written + "`");
    PathEntry entry{.kind = kind_of(item.text_of("path_type")),
                    .sha256 = item.text_of("sha256"),
                    .placeholder = item.text_of("prefix_placeholder")};
    if (const JsonValue* size = item.find("size_in_bytes"); size != nullptr) {
      const auto value = size->unsigned_integer();
      entry.size_known = value.has_value();
      entry.size = value.value_or(0);
    }
    if (!entry.placeholder.empty()) {
      entry.mode = item.text_of("file_mode") == "binary" ? PrefixMode::kBinary : PrefixMode::kText;
    }
    if (!entries.emplace(*path, std::move(entry)).second) {
      return damaged_archive(name, "info/paths.json names `" + *path + "` twice");
    }
  }
  return entries;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

/// Words between spaces; quotes hold one together.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  char quote = '\0';
  bool open = false;
  for (const char c : line) {
    if (quote == '\0' && (c == ' ' || c == '\t')) {
      open = false;
    } else if (c == quote) {
      quote = '\0';
    } else if (quote == '\0' && (c == '"' || c == '\'')) {
      quote = c;
    } else {
      if (!open) words.emplace_back();
      open = true;
      words.back() += c;
    }
  }
  return words;
}

Outcome<Paths> parse_old_lists(const PackageLists& lists, const std::string& name) {
  Paths entries;
  for (const std::string_view line : lines_of(*lists.files)) {
    const auto path = safe_member_path(line);
    if (!path)
      return damaged_archive(name, "info/files names the path `" + std::string(line) + "`");
    entries.try_emplace(*path);
  }
  for (const std::string_view line :
       lines_of(lists.has_prefix ? *lists.has_prefix : std::string_view())) {
    std::vector<std::string> words = words_of(line);
    if (words.size() == 1) words.insert(words.begin(), {kOldPlaceholder, "text"});
    const auto path = words.size() == 3 ? safe_member_path(words[2]) : std::nullopt;
    const auto entry = path ? entries.find(*path) : entries.end();
    if (entry == entries.end() || (words[1] != "text" && words[1] != "binary"))
      return damaged_archive(name, "info/has_prefix has the line `" + std::string(line) + "`");
    entry->second.placeholder = words[0];
    entry->second.mode = words[1] == "binary" ? PrefixMode::kBinary : PrefixMode::kText;
  }
  return entries;
}

}  // namespace

Outcome<Paths> package_paths(const PackageLists& lists, const std::string& name) {
  if (lists.paths_json) return parse_paths_json(*lists.paths_json, name);
  if (lists.files) return parse_old_lists(lists, name);
  return damaged_archive(name, "it has neither info/paths.json nor info/files");
}

}  // namespace ros2wasm
