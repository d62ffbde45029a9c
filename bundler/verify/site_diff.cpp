// See site_diff.hpp.
#include "bundler/verify/site_diff.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "bundler/archive/wasm_module.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace {

/// By number, as the core specification names them; exceptions added the last.
constexpr std::array<std::string_view, 14> kSectionNames = {
    "custom", "type",  "import",  "function", "table", "memory",     "global",
    "export", "start", "element", "code",     "data",  "data count", "tag"};

std::string name_of(const WasmSection& section) {
  if (section.id == 0) return "custom section `" + section.name + "`";
  if (section.id >= kSectionNames.size()) return "section " + std::to_string(section.id);
  return "section `" + std::string(kSectionNames[section.id]) + "`";
}

std::string bytes_at(std::size_t offset, std::size_t first, std::size_t second) {
  std::string text = "byte " + std::to_string(offset);
  if (first != second)
    text += " (" + std::to_string(first) + " and " + std::to_string(second) + " bytes)";
  return text;
}

/// The first section that is not the same in both.
std::string in_module(std::string_view first, std::string_view second, const WasmModule& a,
                      const WasmModule& b) {
  for (std::size_t i = 0; i < std::max(a.sections.size(), b.sections.size()); ++i) {
    if (i == a.sections.size()) return name_of(b.sections[i]) + ", which only the second has";
    if (i == b.sections.size()) return name_of(a.sections[i]) + ", which only the first has";
    const WasmSection& one = a.sections[i];
    const WasmSection& other = b.sections[i];
    const std::string_view ours = first.substr(one.begin, one.end - one.begin);
    const std::string_view theirs = second.substr(other.begin, other.end - other.begin);
    if (ours == theirs) continue;
    if (one.id != other.id || one.name != other.name)
      return name_of(one) + ", where the second has " + name_of(other);
    const auto at = static_cast<std::size_t>(
        std::mismatch(ours.begin(), ours.end(), theirs.begin(), theirs.end()).first - ours.begin());
    return name_of(one) + ", " + bytes_at(at, ours.size(), theirs.size()) + " of it";
  }
  return {};
}

bool same(const JsonValue& a, const JsonValue& b);

/// Key -> value of an object, the last one where a key is there twice, as JsonValue::find(), which
/// looks at all members for each key.
std::map<std::string_view, const JsonValue*> by_key(const JsonValue& object) {
  std::map<std::string_view, const JsonValue*> result;
  for (const auto& [key, value] : object.members()) result.insert_or_assign(key, &value);
  return result;
}

bool same_members(const JsonValue& a, const JsonValue& b) {
  if (a.members().size() != b.members().size()) return false;
  const auto others = by_key(b);
  return std::all_of(a.members().begin(), a.members().end(), [&](const JsonValue::Member& member) {
    const auto other = others.find(member.first);
    return other != others.end() && same(member.second, *other->second);
  });
}

bool same(const JsonValue& a, const JsonValue& b) {
  if (a.is_object() && b.is_object()) return same_members(a, b);
  if (a.is_array() && b.is_array())
    return std::equal(a.items().begin(), a.items().end(), b.items().begin(), b.items().end(), same);
  if (a.string() != nullptr && b.string() != nullptr) return *a.string() == *b.string();
  if (a.is_object() || b.is_object() || a.is_array() || b.is_array()) return false;
  return a.is_null() == b.is_null() && a.boolean() == b.boolean() && a.number() == b.number() &&
         (a.string() == nullptr) == (b.string() == nullptr);
}

std::string shown(const JsonValue& value) {
  if (const std::string* text = value.string()) return "`" + text->substr(0, 60) + "`";
  if (const auto yes = value.boolean()) return *yes ? "`true`" : "`false`";
  if (const auto whole = value.integer()) return "`" + std::to_string(*whole) + "`";
  if (value.is_array()) return std::to_string(value.items().size()) + " items";
  return "another value";
}

/// "nodes[2].arguments: 3 items, the second has 4 items". `except` is a key that is passed over at
/// the top.
std::string in_json(const std::string& at, const JsonValue& a, const JsonValue& b,
                    std::string_view except = {}) {
  if (a.is_object() && b.is_object()) {
    const std::string dot = at.empty() ? "" : at + ".";
    const auto firsts = by_key(a);
    const auto others = by_key(b);
    for (const auto& [key, value] : a.members()) {
      if (key == except) continue;
      const auto other = others.find(key);
      if (other == others.end()) return "`" + dot + key + "`, which only the first has";
      if (!same(value, *other->second)) return in_json(dot + key, value, *other->second);
    }
    for (const auto& [key, value] : b.members()) {
      if (key != except && !firsts.contains(key))
        return "`" + dot + key + "`, which only the second has";
    }
    return {};
  }
  if (a.is_array() && b.is_array() && a.items().size() == b.items().size()) {
    for (std::size_t i = 0; i < a.items().size(); ++i) {
      if (!same(a.items()[i], b.items()[i]))
        return in_json(at + "[" + std::to_string(i) + "]", a.items()[i], b.items()[i]);
    }
  }
  return "`" + at + "`: " + shown(a) + ", the second has " + shown(b);
}

/// Nothing for what is not text.
std::optional<std::string> in_text(std::string_view first, std::string_view second,
                                   std::size_t at) {
  if (first.find('\0') != std::string_view::npos || second.find('\0') != std::string_view::npos)
    return std::nullopt;
  const auto line =
      std::count(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return "line " + std::to_string(line + 1);
}

std::string_view word_of(SiteChange change) {
  switch (change) {
    case SiteChange::kChanged:
      return "changed";
    case SiteChange::kOnlyFirst:
      return "only_first";
    case SiteChange::kOnlySecond:
      return "only_second";
  }
  return "changed";
}

}  // namespace

std::string first_difference(const std::string& path, std::string_view first,
                             std::string_view second) {
  const auto at = static_cast<std::size_t>(
      std::mismatch(first.begin(), first.end(), second.begin(), second.end()).first -
      first.begin());
  const auto a = read_wasm_module(first);
  const auto b = read_wasm_module(second);
  if (a && b) return in_module(first, second, *a, *b);
  if (path.ends_with(".json")) {
    const auto one = parse_json(first, path, "R2W0605");
    const auto other = parse_json(second, path, "R2W0605");
    if (one && other) {
      // The files are compared one by one.
      if (std::string where = in_json("", *one, *other, "files"); !where.empty()) return where;
      return {};
    }
  }
  if (const auto line = in_text(first, second, at)) return *line;
  return bytes_at(at, first.size(), second.size());
}

void write_differences(JsonWriter& json, const std::vector<SiteDifference>& differences) {
  for (const SiteDifference& one : differences) {
    json.begin_object().field("path", one.path).field("change", word_of(one.change));
    if (!one.where.empty()) json.field("where", one.where);
    json.field("reason", one.reason).end_object();
  }
}

std::string difference_line(const SiteDifference& one) {
  switch (one.change) {
    case SiteChange::kChanged:
      return one.path + ": differs in " + one.where + " (" + one.reason + ")";
    case SiteChange::kOnlyFirst:
      return one.path + ": only in the first site (" + one.reason + ")";
    case SiteChange::kOnlySecond:
      return one.path + ": only in the second site (" + one.reason + ")";
  }
  return one.path;
}

Outcome<std::vector<SiteDifference>> site_differences(const ComparedSite& first,
                                                      const ComparedSite& second) {
  std::vector<SiteDifference> result;
  if (first.list.hash == second.list.hash) return result;
  // A difference that only follows from the hashes of other files is not reported.
  if (std::string where = first_difference(kSiteJsonName, first.description, second.description);
      !where.empty())
    result.push_back({.path = kSiteJsonName, .reason = "what runs in the site", .where = where});
  std::map<std::string, const ListedFile*> theirs;
  for (const ListedFile& file : second.list.files) theirs.emplace(file.path, &file);
  std::map<std::string, SiteDifference> by_path;
  for (const ListedFile& file : first.list.files) {
    const auto other = theirs.find(file.path);
    if (other == theirs.end()) {
      by_path[file.path] = {SiteChange::kOnlyFirst, file.path, file.reason, {}};
      continue;
    }
    if (other->second->sha256 != file.sha256) {
      const auto ours = first.bytes(file.path);
      if (!ours) return ours.errors();
      const auto bytes = second.bytes(file.path);
      if (!bytes) return bytes.errors();
      by_path[file.path] = {SiteChange::kChanged, file.path, file.reason,
                            first_difference(file.path, *ours, *bytes)};
    }
    theirs.erase(other);
  }
  for (const auto& [path, file] : theirs)
    by_path[path] = {SiteChange::kOnlySecond, path, file->reason, {}};
  for (auto& [path, difference] : by_path) result.push_back(std::move(difference));
  // The same files for other reasons, or in another order.
  if (result.empty())
    result.push_back({.path = kSiteJsonName,
                      .reason = "what runs in the site",
                      .where = "what it says of its files"});
  return result;
}

}  // namespace ros2wasm
