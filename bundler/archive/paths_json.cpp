// See paths_json.hpp.
#include "bundler/archive/paths_json.hpp"

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/link_rules.hpp"
#include "workspace_schema/json_reader.hpp"

namespace ros2wasm {
namespace {

PathKind kind_of(const std::string& path_type) {
  if (path_type == "softlink") return PathKind::kLink;
  return path_type == "directory" ? PathKind::kDirectory : PathKind::kFile;
}

}  // namespace

Outcome<std::map<std::string, PathEntry>> parse_paths_json(std::string_view text,
                                                           const std::string& name) {
  const auto json = parse_json(text, "info/paths.json of " + name, "R2W0221");
  if (!json) return json.errors();
  const JsonValue* paths = json->find("paths");
  if (paths == nullptr || !paths->is_array())
    return damaged_archive(name, "info/paths.json has no list `paths`");
  std::map<std::string, PathEntry> entries;
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

}  // namespace ros2wasm
