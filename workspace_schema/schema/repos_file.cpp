// See repos_file.hpp.
#include "workspace_schema/schema/repos_file.hpp"

#include <algorithm>
#include <set>

#include "workspace_schema/base/hash_text.hpp"
#include "workspace_schema/base/yaml_reader.hpp"
#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {
namespace {

class ReposReader {
 public:
  explicit ReposReader(const SourceText& source) : source_(source) {}

  Outcome<std::vector<NamedSource>> read() {
    auto document = parse_yaml(source_);
    if (!document) {
      for (Diagnostic one : document.errors()) refuse(std::move(one));
      return std::move(faults_);
    }
    for (Diagnostic& one : document->problems) refuse(std::move(one));
    const YamlNode* repositories = value_of(document->root, "repositories");
    if (repositories == nullptr || repositories->kind != YamlKind::kMap) {
      fault({0, 1}, "it has no mapping `repositories`");
    } else {
      for (const YamlEntry& entry : repositories->entries) read_repository(entry);
    }
    if (!faults_.empty()) return std::move(faults_);
    return std::move(entries_);
  }

 private:
  void refuse(Diagnostic one) {
    one.code = "R2W0250";
    faults_.push_back(std::move(one));
  }

  void fault(TextRange range, const std::string& why) {
    faults_.push_back(Diagnostic{
        .code = "R2W0250",
        .message = "`" + source_.file() + "` is not a .repos file that can be used: " + why,
        .span = source_.span(range.offset, range.length)});
  }

  /// A text or a number as it is written; empty when it is neither.
  static std::string scalar(const YamlNode* node) {
    return node != nullptr && node->kind == YamlKind::kScalar ? node->text : std::string();
  }

  void read_repository(const YamlEntry& entry) {
    const std::string type = scalar(value_of(entry.value, "type"));
    NamedSource made{.kind = type == "git" ? SourceKind::kGit : SourceKind::kArchive,
                     .place = scalar(value_of(entry.value, "url")),
                     .revision = {},
                     .sha256 = {},
                     .name = {},
                     .repos = source_.file(),
                     .packages = {},
                     .package_places = {},
                     .span = source_.span(entry.key_range.offset, entry.key_range.length)};
    if (type != "git" && type != "tar" && type != "zip")
      return fault(entry.key_range, type.empty() ? "`" + entry.key + "` has no `type`"
                                                 : "`" + entry.key + "` is of the type `" + type +
                                                       "`; git, tar and zip are read");
    if (made.place.empty()) return fault(entry.key_range, "`" + entry.key + "` has no `url`");
    if (made.kind == SourceKind::kGit) {
      made.revision = scalar(value_of(entry.value, "version"));
      if (const std::string bad = git_address_fault(made.place); !bad.empty())
        return fault(entry.key_range, "the address of `" + entry.key + "`: " + bad);
      if (const std::string bad = git_revision_fault(made.revision); !bad.empty())
        return fault(entry.key_range, "the version of `" + entry.key + "`: " + bad);
    } else {
      // Only ours: vcs reads no hash, and skips keys that it does not know.
      made.sha256 = scalar(value_of(entry.value, "sha256"));
      if (const std::string bad = file_place_fault(made.place); !bad.empty())
        return fault(entry.key_range, "the address of `" + entry.key + "`: " + bad);
      if (!made.sha256.empty() && !is_sha256_text(made.sha256))
        return fault(entry.key_range,
                     "`sha256` of `" + entry.key + "` must be 64 hexadecimal digits in lower case");
      if (is_web_place(made.place) && made.sha256.empty())
        return fault(entry.key_range, "the archive `" + entry.key +
                                          "` needs a line `sha256:`, as whoever has its address "
                                          "may put something else there");
    }
    made.name = source_name(made.place);
    entries_.push_back(std::move(made));
  }

  const SourceText& source_;
  std::vector<NamedSource> entries_;
  Diagnostics faults_;
};

}  // namespace

Outcome<std::vector<NamedSource>> read_repos_file(std::string_view text, const std::string& file) {
  const SourceText source(text, file);
  return ReposReader(source).read();
}

}  // namespace ros2wasm
