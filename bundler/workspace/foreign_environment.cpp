// See foreign_environment.hpp. The TOML of pixi.toml is read in pixi_manifest.cpp.
#include "bundler/workspace/foreign_environment.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "bundler/workspace/pixi_manifest.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/base/yaml_scalar.hpp"
#include "workspace_schema/conda/match_spec.hpp"
#include "workspace_schema/conda/match_spec_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kPlatform = "emscripten-wasm32";

const YamlNode* find(const YamlNode& map, std::string_view key) {
  for (const YamlEntry& entry : map.entries)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

std::string text_at(const YamlNode& map, std::string_view key) {
  const YamlNode* node = find(map, key);
  return node != nullptr && node->kind == YamlKind::kScalar ? node->text : std::string();
}

std::uint64_t number_at(const YamlNode& map, std::string_view key) {
  const YamlNode* node = find(map, key);
  if (node == nullptr || node->kind != YamlKind::kScalar) return 0;
  const YamlValue value = scalar_value(*node);
  const auto* number = std::get_if<std::int64_t>(&value);
  return number != nullptr && *number > 0 ? static_cast<std::uint64_t>(*number) : 0;
}

std::vector<std::string> texts_at(const YamlNode& map, std::string_view key) {
  std::vector<std::string> texts;
  const YamlNode* node = find(map, key);
  if (node == nullptr) return texts;
  for (const YamlNode& item : node->items)
    if (item.kind == YamlKind::kScalar) texts.push_back(item.text);
  return texts;
}

std::string without_last_slash(std::string text) {
  while (text.ends_with('/')) text.pop_back();
  return text;
}

/// Fills what the address of an archive says: file, subdir, channel, and name, version, build.
bool read_address(PackageRecord& record) {
  record.file_name = std::string(last_part(record.url));
  if (!is_archive_name(record.file_name)) return false;
  const std::size_t ending = record.file_name.ends_with(".conda") ? 6 : 8;
  const std::string stem = record.file_name.substr(0, record.file_name.size() - ending);
  const std::size_t build = stem.rfind('-');
  const std::size_t version =
      build == std::string::npos || build == 0 ? std::string::npos : stem.rfind('-', build - 1);
  if (version == std::string::npos || version == 0) return false;
  if (record.name.empty()) record.name = stem.substr(0, version);
  if (record.version.empty()) record.version = stem.substr(version + 1, build - version - 1);
  if (record.build.empty()) record.build = stem.substr(build + 1);
  if (record.url.size() <= record.file_name.size()) return false;
  const std::string folder = record.url.substr(0, record.url.size() - record.file_name.size() - 1);
  record.subdir = std::string(last_part(folder));
  record.channel = without_last_slash(folder.substr(0, folder.size() - record.subdir.size()));
  if (record.subdir == "noarch") record.noarch = NoarchKind::kGeneric;
  return !record.channel.empty();
}

class Reader {
 public:
  Reader(const SourceText& source, std::string environment)
      : source_(source), wanted_(std::move(environment)) {}

  Outcome<ForeignEnvironment> read() {
    auto document = parse_yaml(source_);
    if (!document) return fault({0, 1}, document.errors().front().message);
    const YamlNode& root = document->root;
    if (find(root, "environments") != nullptr && find(root, "packages") != nullptr)
      return pixi_lock(root);
    if (find(root, "package") != nullptr && find(root, "metadata") != nullptr)
      return conda_lock(root);
    if (find(root, "dependencies") != nullptr) return environment_file(root);
    return fault({0, 1}, "it is not an environment.yml, pixi.toml, pixi.lock or conda-lock file");
  }

 private:
  Diagnostic fault(TextRange range, const std::string& why) const {
    return Diagnostic{.code = "R2W0340",
                      .message = "`" + source_.file() + "` cannot be converted: " + why,
                      .span = source_.span(range.offset, range.length)};
  }

  Diagnostic not_for_us(const std::set<std::string>& others) const {
    Diagnostic made{
        .code = "R2W0341",
        .message = "`" + source_.file() + "` has no packages for " + std::string(kPlatform)};
    std::string names;
    for (const std::string& one : others) names += (names.empty() ? "" : ", ") + one;
    if (!names.empty()) made.why.push_back("it has packages for " + names);
    return made;
  }

  Outcome<ForeignEnvironment> environment_file(const YamlNode& root) {
    ForeignEnvironment made{.format = "environment.yml", .name = text_at(root, "name")};
    for (const std::string& channel : texts_at(root, "channels")) {
      if (channel != "nodefaults") made.channels.push_back(without_last_slash(channel));
    }
    for (const YamlNode& item : find(root, "dependencies")->items) {
      if (item.kind == YamlKind::kScalar) {
        if (auto spec = MatchSpec::parse(item.text); !spec)
          return fault(item.range, spec.errors().front().message);
        made.specs.push_back(item.text);
        continue;
      }
      for (const YamlEntry& entry : item.entries) {
        for (const YamlNode& one : entry.value.items)
          made.left_out.push_back(one.text + " (of " + entry.key + ")");
      }
    }
    return made;
  }

  Outcome<ForeignEnvironment> pixi_lock(const YamlNode& root) {
    const YamlNode* chosen = nullptr;
    std::set<std::string> others;
    ForeignEnvironment made{.format = "pixi.lock"};
    for (const YamlEntry& entry : find(root, "environments")->entries) {
      const YamlNode* packages = find(entry.value, "packages");
      if (packages == nullptr) continue;
      for (const YamlEntry& platform : packages->entries) others.insert(platform.key);
      if (find(*packages, kPlatform) == nullptr) continue;
      const bool better = chosen == nullptr || entry.key == "default";
      if (wanted_.empty() ? !better : entry.key != wanted_) continue;
      chosen = &entry.value;
      made.name = entry.key;
    }
    if (chosen == nullptr) return not_for_us(others);
    if (const YamlNode* channels = find(*chosen, "channels")) {
      for (const YamlNode& one : channels->items)
        made.channels.push_back(without_last_slash(text_at(one, "url")));
    }
    std::set<std::string> urls;
    for (const YamlNode& item : find(*find(*chosen, "packages"), kPlatform)->items) {
      if (const std::string url = text_at(item, "conda"); !url.empty()) {
        urls.insert(url);
      } else {
        made.left_out.push_back(text_at(item, "pypi") + " (of PyPI)");
      }
    }
    for (const YamlNode& item : find(root, "packages")->items) {
      const bool old_form = text_at(item, "kind") == "conda";
      PackageRecord record{.name = text_at(item, "name"), .version = text_at(item, "version")};
      record.build = text_at(item, "build");
      record.url = text_at(item, old_form ? "url" : "conda");
      if (urls.erase(record.url) == 0) continue;
      if (!read_address(record))
        return fault(item.range, "`" + record.url + "` is not an address of an archive");
      record.build_number = number_at(item, "build_number");
      read_common(item, record);
      record.timestamp_ms = static_cast<std::int64_t>(number_at(item, "timestamp"));
      record.depends = texts_at(item, "depends");
      record.constrains = texts_at(item, "constrains");
      if (const YamlNode* noarch = find(item, "noarch");
          noarch != nullptr && noarch->text == "python")
        record.noarch = NoarchKind::kPython;
      made.packages.push_back(std::move(record));
    }
    if (!urls.empty()) return fault({0, 1}, "nothing is said of `" + *urls.begin() + "`");
    return finished(std::move(made));
  }

  static void read_common(const YamlNode& item, PackageRecord& record) {
    record.sha256 = text_at(item, "sha256");
    record.md5 = text_at(item, "md5");
    record.size = number_at(item, "size");
    record.license = text_at(item, "license");
  }

  Outcome<ForeignEnvironment> conda_lock(const YamlNode& root) {
    ForeignEnvironment made{.format = "conda-lock"};
    if (const YamlNode* channels = find(*find(root, "metadata"), "channels")) {
      for (const YamlNode& one : channels->items)
        made.channels.push_back(without_last_slash(text_at(one, "url")));
    }
    std::set<std::string> others;
    for (const YamlNode& item : find(root, "package")->items) {
      others.insert(text_at(item, "platform"));
      if (text_at(item, "platform") != kPlatform) continue;
      if (text_at(item, "manager") != "conda") {
        made.left_out.push_back(text_at(item, "name") + " (of " + text_at(item, "manager") + ")");
        continue;
      }
      PackageRecord record{.name = text_at(item, "name"), .version = text_at(item, "version")};
      record.url = text_at(item, "url");
      if (!read_address(record))
        return fault(item.range, "`" + record.url + "` is not an address of an archive");
      if (const YamlNode* hash = find(item, "hash")) read_common(*hash, record);
      if (const YamlNode* dependencies = find(item, "dependencies")) {
        for (const YamlEntry& one : dependencies->entries)
          record.depends.push_back(one.value.text.empty() ? one.key
                                                          : one.key + " " + one.value.text);
      }
      made.packages.push_back(std::move(record));
    }
    if (made.packages.empty()) return not_for_us(others);
    return finished(std::move(made));
  }

  /// Sorts, refuses what cannot be a solution's list, and finds the packages that nobody needs.
  Outcome<ForeignEnvironment> finished(ForeignEnvironment made) const {
    std::sort(made.packages.begin(), made.packages.end(),
              [](const PackageRecord& a, const PackageRecord& b) { return a.name < b.name; });
    std::set<std::string> needed;
    for (std::size_t i = 0; i < made.packages.size(); ++i) {
      const PackageRecord& record = made.packages[i];
      if (i > 0 && record.name == made.packages[i - 1].name)
        return fault({0, 1}, "`" + record.name + "` is there twice");
      for (const std::string& text : record.depends) {
        const auto spec = MatchSpec::parse(text);
        const auto name = spec ? spec->exact_name() : std::nullopt;
        if (name && *name != record.name) needed.insert(*name);
      }
    }
    for (const PackageRecord& record : made.packages)
      if (!needed.contains(record.name)) made.specs.push_back(record.name);
    return made;
  }

  const SourceText& source_;
  std::string wanted_;
};

}  // namespace

Outcome<ForeignEnvironment> read_foreign_environment(std::string_view text, const std::string& file,
                                                     const std::string& environment) {
  if (file.ends_with(".toml")) return read_pixi_manifest(text, file);
  const SourceText source(text, file);
  return Reader(source, environment).read();
}

}  // namespace ros2wasm
