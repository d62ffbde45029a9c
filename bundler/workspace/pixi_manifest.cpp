// See pixi_manifest.hpp. The TOML library ends here.
#include "bundler/workspace/pixi_manifest.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include "workspace_schema/base/source_text.hpp"
#include "workspace_schema/conda/match_spec.hpp"

namespace ros2wasm {
namespace {

std::string text_of(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string());
}

/// "name" and what pixi says of it as one match spec; empty for what is not a conda package.
std::string spec_of(const std::string& name, const toml::node& value) {
  if (const auto text = value.value<std::string>()) return *text == "*" ? name : name + " " + *text;
  const toml::table* fields = value.as_table();
  if (fields == nullptr || fields->empty() || fields->contains("git") || fields->contains("path"))
    return {};
  const std::string channel = text_of(*fields, "channel");
  std::string spec = channel.empty() ? name : channel + "::" + name;
  const std::string version = text_of(*fields, "version");
  if (!version.empty() && version != "*") spec += " " + version;
  if (const std::string build = text_of(*fields, "build"); !build.empty())
    spec += "[build='" + build + "']";
  return spec;
}

struct Dependency {
  std::string name;
  const toml::node* value;
  toml::source_position place;
};

/// The entries of a table in the order of the file.
std::vector<Dependency> entries_of(const toml::node_view<const toml::node>& node) {
  std::vector<Dependency> found;
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      found.push_back({std::string(key.str()), &value, key.source().begin});
  }
  std::sort(found.begin(), found.end(),
            [](const Dependency& a, const Dependency& b) { return a.place < b.place; });
  return found;
}

/// Tables of dependencies that are not for this platform, or not of conda: all are named below
/// `path`.
void leave_out(const toml::table& table, const std::string& path, bool mine,
               std::vector<std::string>& left_out) {
  for (const auto& [key, value] : table) {
    const toml::table* inner = value.as_table();
    if (inner == nullptr) continue;
    const std::string name(key.str());
    const bool own = mine && name == "dependencies";
    if (name.ends_with("dependencies") && !own) {
      for (const Dependency& one : entries_of(toml::node_view<const toml::node>(value)))
        left_out.push_back(one.name + " (of " + (path.empty() ? name : path) + ")");
    } else if (!own) {
      leave_out(*inner, path.empty() ? name : path, name == "emscripten-wasm32" && path == "target",
                left_out);
    }
  }
}

std::size_t offset_of(std::string_view text, const toml::source_position& place) {
  std::size_t offset = 0;
  for (toml::source_index line = 1; line < place.line; ++line) {
    const std::size_t end = text.find('\n', offset);
    if (end == std::string_view::npos) break;
    offset = end + 1;
  }
  const std::size_t column = place.column > 0 ? place.column - 1 : 0;
  return std::min(offset + column, text.size());
}

}  // namespace

Outcome<ForeignEnvironment> read_pixi_manifest(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  const auto fault = [&](const toml::source_position& place, std::string_view why) {
    return Diagnostic{.code = "R2W0340",
                      .message = "`" + source.file() + "` cannot be converted: " + std::string(why),
                      .span = source.span(offset_of(text, place), 1)};
  };
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) return fault(parsed.error().source().begin, parsed.error().description());
  const toml::table& whole = parsed.table();
  const toml::table* embedded = whole["tool"]["pixi"].as_table();
  const toml::table& top = embedded != nullptr ? *embedded : whole;

  ForeignEnvironment made{.format = "pixi.toml"};
  const auto workspace = top["workspace"].is_table() ? top["workspace"] : top["project"];
  const toml::array* channels = workspace["channels"].as_array();
  if (channels == nullptr)
    return fault({1, 1}, "it has no `channels` under [workspace] or [project]");
  made.name = workspace["name"].value_or(std::string());
  for (const toml::node& one : *channels) {
    const toml::table* fields = one.as_table();
    made.channels.push_back(fields != nullptr ? text_of(*fields, "channel")
                                              : one.value_or(std::string()));
  }
  const auto own = {top["dependencies"], top["target"]["emscripten-wasm32"]["dependencies"]};
  for (const auto& table : own) {
    for (const Dependency& one : entries_of(table)) {
      const std::string spec = spec_of(one.name, *one.value);
      if (spec.empty()) {
        made.left_out.push_back(one.name + " (from elsewhere than a channel)");
      } else if (const auto read = MatchSpec::parse(spec); !read) {
        return fault(one.place, read.errors().front().message);
      } else {
        made.specs.push_back(spec);
      }
    }
  }
  leave_out(top, "", true, made.left_out);
  return made;
}

}  // namespace ros2wasm
