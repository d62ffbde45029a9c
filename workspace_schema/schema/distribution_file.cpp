// See distribution_file.hpp.
#include "workspace_schema/schema/distribution_file.hpp"

#include <vector>

#include "workspace_schema/base/long_yaml.hpp"
#include "workspace_schema/base/replaced_text.hpp"
#include "workspace_schema/schema/manifest_binding.hpp"
#include "workspace_schema/schema/named_source.hpp"

namespace ros2wasm {
namespace {

using Released = std::map<std::string, ReleasedPackage>;

constexpr std::size_t kLongestTexts = 2000;  // bytes

Diagnostic not_a_distribution(const std::string& file, const std::string& why) {
  return Diagnostic{
      .code = "R2W0256",
      .message = "`" + file + "` is not a distribution file that can be used: " + why};
}

/// A text or a number as it is written; empty when it is neither.
std::string scalar_of(const YamlNode& map, std::string_view key) {
  const YamlNode* node = value_of(map, key);
  return node != nullptr && node->kind == YamlKind::kScalar ? node->text : std::string();
}

/// A repository without a list has one package, with its own name.
std::vector<std::string> packages_of(const std::string& repository, const YamlNode& release) {
  const YamlNode* list = value_of(release, "packages");
  if (list == nullptr || list->kind != YamlKind::kSequence) return {repository};
  std::vector<std::string> names;
  for (const YamlNode& one : list->items)
    if (one.kind == YamlKind::kScalar) names.push_back(one.text);
  return names;
}

void add_repository(const std::string& repository, const YamlNode& release, Released& released) {
  const YamlNode* tags = value_of(release, "tags");
  const std::string pattern = tags == nullptr ? "" : scalar_of(*tags, "release");
  const std::string url = scalar_of(release, "url");
  const std::string version = scalar_of(release, "version");
  if (pattern.empty() || url.empty() || version.empty()) return;
  // Each package has a copy of them.
  if (pattern.size() + url.size() + version.size() > kLongestTexts) return;
  if (!is_source_address(url) || !git_address_fault(url).empty()) return;
  for (const std::string& name : packages_of(repository, release)) {
    if (package_name_fault(name)) continue;
    const std::string tag =
        with_replaced(with_replaced(pattern, "{package}", name), "{version}", version);
    if (git_revision_fault(tag).empty())
      released.try_emplace(name, ReleasedPackage{.url = url, .tag = tag, .version = version});
  }
}

}  // namespace

Outcome<Released> read_distribution_file(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  const auto document = parse_long_yaml(source);
  if (!document) return not_a_distribution(file, document.errors().front().message);
  const YamlNode* repositories = value_of(document->root, "repositories");
  if (scalar_of(document->root, "type") != "distribution" || repositories == nullptr ||
      repositories->kind != YamlKind::kMap)
    return not_a_distribution(file, "it has no `type: distribution` and mapping `repositories`");
  Released released;
  for (const YamlEntry& entry : repositories->entries) {
    const YamlNode* release = value_of(entry.value, "release");
    if (release != nullptr) add_repository(entry.key, *release, released);
  }
  return released;
}

}  // namespace ros2wasm
