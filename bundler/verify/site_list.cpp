// See site_list.hpp.
#include "bundler/verify/site_list.hpp"

#include <algorithm>
#include <set>

#include "bundler/io/sha256.hpp"
#include "bundler/plan/site_path.hpp"
#include "bundler/plan/site_plan.hpp"
#include "bundler/render/site_json.hpp"
#include "workspace_schema/json_reader.hpp"

namespace ros2wasm {
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 40U;

bool is_sha256(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Diagnostic no_site(const std::string& shown, std::string why) {
  return Diagnostic{.code = "R2W0605",
                    .message = "`" + shown + "` is not the site.json of a site",
                    .why = {std::move(why)},
                    .fix = {}};
}

}  // namespace

Outcome<SiteList> read_site_list(std::string_view site_json, const std::string& shown) {
  const auto json = parse_json(site_json, shown, "R2W0605");
  if (!json) return json.errors();
  SiteList list{.hash = sha256_hex(site_json),
                .generator = json->text_of("generator"),
                .carried_page_sha256 = json->text_of("carried_page_sha256"),
                .files = {}};
  if (!list.generator.starts_with(kSiteGenerator))
    return no_site(shown, "its `generator` is not ros2wasm");
  const JsonValue* files = json->find("files");
  if (files == nullptr || !files->is_array()) return no_site(shown, "it lists no files");
  std::set<std::string> seen;
  for (const JsonValue& one : files->items()) {
    const JsonValue* size = one.find("size");
    const auto bytes = size == nullptr ? std::nullopt : size->unsigned_integer();
    ListedFile file{.path = one.text_of("path"),
                    .size = bytes.value_or(0),
                    .sha256 = one.text_of("sha256"),
                    .reason = one.text_of("reason")};
    if (!bytes || *bytes > kLargestFile || !is_sha256(file.sha256))
      return no_site(shown, "`" + file.path + "` has no size that can be, or no sha256");
    if (auto refusal = refuse_site_path(file.path)) return *refusal;
    if (!seen.insert(file.path).second) return no_site(shown, "`" + file.path + "` stands twice");
    list.files.push_back(std::move(file));
  }
  return list;
}

std::string hash_list(const SiteList& list) {
  std::vector<PlannedFile> files{
      {.path = kSiteJsonName, .reason = {}, .bytes = {}, .sha256 = list.hash}};
  for (const ListedFile& file : list.files)
    files.push_back({.path = file.path, .reason = {}, .bytes = {}, .sha256 = file.sha256});
  std::sort(files.begin(), files.end(),
            [](const PlannedFile& a, const PlannedFile& b) { return a.path < b.path; });
  return hash_list(files);
}

}  // namespace ros2wasm
