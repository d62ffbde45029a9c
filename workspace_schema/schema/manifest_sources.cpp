// See manifest_sources.hpp.
#include "workspace_schema/schema/manifest_sources.hpp"

#include <array>

#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

constexpr auto kSourceKinds =
    std::to_array<SourceKind>({SourceKind::kGit, SourceKind::kArchive, SourceKind::kFolder,
                               SourceKind::kRepos, SourceKind::kDistribution});

/// Which mean nothing to YAML, as no space stands behind a colon.
constexpr std::string_view kLettersOfAddresses =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-:@";
constexpr std::string_view kSourceForms =
    "a mapping with `git`, `archive`, `folder`, `repos` or `distribution`";

std::optional<Spanned<std::string>> read_git(Binder& binder, const YamlNode& node) {
  auto place = binder.line(node, "git");
  if (!place) return std::nullopt;
  const std::string fault = git_address_fault(place->value);
  if (!fault.empty()) {
    binder.error("R2W0103", "`" + place->value + "` is not the address of a git repository",
                 node.range, fault);
    return std::nullopt;
  }
  return is_source_address(place->value) ? place : binder.path(node, "git");
}

/// An address of the web, or a path.
std::optional<Spanned<std::string>> read_file_place(Binder& binder, const YamlNode& node,
                                                    const std::string& key) {
  auto place = binder.line(node, key);
  if (!place) return std::nullopt;
  if (!is_web_place(place->value)) return binder.path(node, key);
  const std::string fault = file_place_fault(place->value);
  if (fault.empty()) return place;
  binder.error("R2W0103", "`" + key + "` cannot be `" + place->value + "`", node.range, fault);
  return std::nullopt;
}

std::optional<Spanned<std::string>> read_place(Binder& binder, const YamlNode& node,
                                               SourceKind kind) {
  switch (kind) {
    case SourceKind::kGit:
      return read_git(binder, node);
    case SourceKind::kArchive:
    case SourceKind::kDistribution:
      return read_file_place(binder, node, std::string(source_kind_word(kind)));
    case SourceKind::kFolder:
    case SourceKind::kRepos:
      break;
  }
  return binder.path(node, std::string(source_kind_word(kind)));
}

void read_revision(Binder& binder, const YamlNode& node, NamedSource& entry) {
  if (entry.kind != SourceKind::kGit) {
    binder.error("R2W0103", "only a `git` source has a `revision`", node.range);
    return;
  }
  const auto revision = binder.written(node, "revision");
  if (!revision) return;
  const std::string fault = git_revision_fault(revision->value);
  if (fault.empty()) {
    entry.revision = revision->value;
  } else {
    binder.error("R2W0103", "`" + revision->value + "` is not a revision", node.range, fault);
  }
}

void read_hash(Binder& binder, const YamlNode& node, NamedSource& entry) {
  if (entry.kind != SourceKind::kArchive) {
    Diagnostic& wrong =
        binder.error("R2W0103", "only an `archive` source has a `sha256`", node.range);
    wrong.why.emplace_back("a commit of git is named with `revision`");
    return;
  }
  entry.sha256 = binder.sha256(node);
}

void read_source_packages(Binder& binder, const YamlNode& node, NamedSource& entry) {
  const auto names = binder.texts(node, "packages", [&](const YamlNode& item) {
    return binder.name(item, "an item of `packages`", package_name_fault);
  });
  for (const auto& name : names) {
    entry.packages.push_back(name.value);
    entry.package_places.push_back(name.span);
  }
  if (node.kind == YamlKind::kSequence && node.items.empty())
    binder.error("R2W0103", "`packages` of a source must name a package", node.range,
                 "without `packages:`, all of the source are taken");
}

void read_source(Binder& binder, const YamlNode& node, Manifest& manifest) {
  static const std::vector<KeyRow> kKeys{
      {"git", {"url", "uri", "repository"}},
      {"archive", {"tar", "zip"}},
      {"folder", {"path", "directory", "local"}},
      {"repos", {"vcs", "rosinstall"}},
      {"distribution", {"distro", "rosdistro", "index"}},
      {"revision", {"version", "branch", "tag", "commit", "rev"}},
      {"sha256", {"hash", "sha"}},
      {"packages", {"package", "only"}}};
  if (!binder.mapping(node, "a source", kKeys)) {
    Diagnostic& wrong = binder.wrong_type(node, "an item of `sources`", kSourceForms);
    const bool is_plain = node.kind == YamlKind::kScalar &&
                          node.text.find_first_not_of(kLettersOfAddresses) == std::string::npos;
    if (is_plain && node.text.ends_with(".repos"))
      wrong.fix.push_back("write `{repos: " + node.text + "}`");
    if (is_plain && node.text.ends_with(".git"))
      wrong.fix.push_back("write `{git: " + node.text + "}`");
    return;
  }
  SourceKind kind = SourceKind::kGit;
  const YamlNode* place = nullptr;
  for (const SourceKind one : kSourceKinds) {
    const YamlNode* found = value_of(node, source_kind_word(one));
    if (found == nullptr) continue;
    if (place != nullptr) {
      binder.error("R2W0103", "a source is in one place", found->range,
                   "`" + std::string(source_kind_word(kind)) + "` is there too");
      return;
    }
    kind = one;
    place = found;
  }
  if (place == nullptr) {
    if (Diagnostic* missing = binder.missing(node, "a source", "git"))
      missing->why.push_back("it is " + std::string(kSourceForms));
    return;
  }
  NamedSource entry{.kind = kind,
                    .place = {},
                    .revision = {},
                    .sha256 = {},
                    .name = {},
                    .repos = {},
                    .packages = {},
                    .package_places = {},
                    .span = {}};
  if (const YamlNode* revision = value_of(node, "revision"))
    read_revision(binder, *revision, entry);
  if (const YamlNode* sha256 = value_of(node, "sha256")) read_hash(binder, *sha256, entry);
  if (const YamlNode* packages = value_of(node, "packages"))
    read_source_packages(binder, *packages, entry);
  auto found = read_place(binder, *place, kind);
  if (!found) return;
  if (kind == SourceKind::kDistribution && !found->value.ends_with(".yaml") &&
      !found->value.ends_with(".yml")) {
    binder.error("R2W0103", "`distribution` must name a YAML file", place->range,
                 "ends with neither `.yaml` nor `.yml`");
    return;
  }
  entry.place = std::move(found->value);
  entry.span = std::move(found->span);
  entry.name = source_name(entry.place);
  if (kind == SourceKind::kArchive && is_web_place(entry.place) &&
      value_of(node, "sha256") == nullptr) {
    if (Diagnostic* missing = binder.missing(node, "an archive from an address", "sha256"))
      missing->why.emplace_back("whoever has the address may put something else there");
  }
  manifest.sources.push_back(std::move(entry));
}

}  // namespace

void read_sources(Binder& binder, const YamlNode& node, Manifest& manifest) {
  binder.list(node, "sources", [&](const YamlNode& item) { read_source(binder, item, manifest); });
}

}  // namespace ros2wasm
