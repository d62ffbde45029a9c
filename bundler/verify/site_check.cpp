// See site_check.hpp.
#include "bundler/verify/site_check.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/plan/shipped_channel.hpp"
#include "bundler/render/carried_page.hpp"
#include "bundler/render/html_text.hpp"
#include "bundler/render/site_plan.hpp"
#include "bundler/site/signature.hpp"
#include "bundler/verify/compressed_forms.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestSignature = 16'384;
constexpr const char* kStep = "verify";

Diagnostic other_bytes(const std::string& path, std::string why) {
  return Diagnostic{.code = "R2W0650",
                    .message = "`" + path + "` is not the file that the site was packed with",
                    .why = {std::move(why)},
                    .fix = {}};
}

Diagnostic not_there(const std::string& path) {
  return Diagnostic{.code = "R2W0651",
                    .message = "`" + path + "` is missing",
                    .why = {path == kHashList ? "every site has it" : "site.json lists it"},
                    .fix = {}};
}

/// SHA256SUMS follows from site.json, which cannot have its hash.
ListedFile listed_hash_list(const SiteList& list) {
  const std::string text = hash_list(list);
  return {.path = kHashList, .size = text.size(), .sha256 = sha256_hex(text), .reason = {}};
}

/// SHA256SUMS, which a site in a store does not have.
std::optional<ListedFile> wanted_hash_list(const SiteList& list) {
  if (!list.store.objects.empty()) return std::nullopt;
  return listed_hash_list(list);
}

/// Copies the list; check_site_folder() does not, since anybody can list half a million files.
std::vector<ListedFile> wanted_of(const SiteList& list) {
  std::vector<ListedFile> wanted = list.files;
  if (auto file = wanted_hash_list(list)) wanted.push_back(std::move(*file));
  return wanted;
}

/// A site whose files are mostly missing is not listed file by file.
constexpr std::size_t kMostFaults = 1000;

Diagnostic too_many_faults() {
  return Diagnostic{.code = "R2W0651",
                    .message = "the other files were not looked at",
                    .why = {std::to_string(kMostFaults) + " of them are missing or other files"},
                    .fix = {}};
}

/// Sorted, for is_listed(): where the files of the site are.
std::vector<std::string> listed_places(const SiteList& list) {
  std::vector<std::string> listed{kSiteJsonName, kHashList};
  listed.reserve(list.files.size() + listed.size());
  for (const ListedFile& file : list.files) {
    for (std::string& place : places_of(file, list)) listed.push_back(std::move(place));
  }
  std::sort(listed.begin(), listed.end());
  return listed;
}

bool is_listed(const std::vector<std::string>& listed, const std::string& place) {
  return std::binary_search(listed.begin(), listed.end(), place);
}

/// `tree` is sorted, as list_tree() gives it.
const TreeEntry* entry_of(const std::vector<TreeEntry>& tree, const std::string& path) {
  const auto found =
      std::lower_bound(tree.begin(), tree.end(), path,
                       [](const TreeEntry& entry, const std::string& p) { return entry.path < p; });
  return found != tree.end() && found->path == path ? &*found : nullptr;
}

/// Nothing when the file has the listed bytes. R2W0210 when it cannot be read at all.
Outcome<std::optional<Diagnostic>> fault_of(const ListedFile& listed,
                                            const std::vector<fs::path>& parts) {
  const auto hashes = hash_parts(parts, std::min(listed.size, kMostOfData));
  if (!hashes) return hashes.errors();
  if (hashes->size != listed.size) {
    return std::optional(other_bytes(listed.path, "it has " + std::to_string(hashes->size) +
                                                      " bytes, site.json says " +
                                                      std::to_string(listed.size)));
  }
  if (hashes->sha256.empty())
    return std::optional(other_bytes(listed.path, "no file of a site has so many bytes"));
  if (hashes->sha256 != listed.sha256) {
    return std::optional(other_bytes(
        listed.path, "its sha256 is " + hashes->sha256 + ", site.json says " + listed.sha256));
  }
  return std::optional<Diagnostic>();
}

/// A listed file in another encoding: `NAME.br`.
bool is_form_of_listed(const std::vector<std::string>& listed, const std::string& path) {
  return std::any_of(kCompressions.begin(), kCompressions.end(), [&](const Compression& form) {
    return path.ends_with(form.ending) &&
           is_listed(listed, path.substr(0, path.size() - form.ending.size()));
  });
}

/// An archive or an index of the channel beside a site, by its name: no browser takes one for a
/// page. Whoever packs from it checks its contents.
bool is_of_channel(const std::string& path) {
  constexpr std::array<std::string_view, 5> kEndings{".conda", ".tar.bz2", "/repodata.json",
                                                     ".json.zst", ".msgpack.zst"};
  return path.starts_with(std::string(kShippedChannel) + "/") &&
         std::any_of(kEndings.begin(), kEndings.end(),
                     [&](std::string_view ending) { return path.ends_with(ending); });
}

/// The files that site.json does not list, except for itself, its signature and the channel that
/// may be beside a site.
std::vector<std::string> unlisted_of(const std::vector<std::string>& listed,
                                     const std::vector<TreeEntry>& tree) {
  std::vector<std::string> result;
  for (const TreeEntry& entry : tree) {
    if (entry.kind == FileKind::kDirectory || entry.path == kSignatureName ||
        entry.path == kPublicKeyName ||
        (entry.kind == FileKind::kFile && is_of_channel(entry.path)) ||
        is_listed(listed, entry.path) || is_form_of_listed(listed, entry.path))
      continue;
    result.push_back(entry.path);
  }
  return result;
}

/// The folder of a site, and what was found out of it once.
struct CheckedFolder {
  const fs::path& folder;
  const SiteList& list;
  const std::vector<std::string>& listed;  ///< listed_places()
  const std::vector<TreeEntry>& tree;
};

/// The forms of one place that have other bytes inside: `.br`.
std::optional<std::string> wrong_form(const CheckedFolder& site, const std::string& place,
                                      std::uint64_t size, const std::string& sha256) {
  return wrong_compressed(site.folder / place, size, sha256, [&](std::string_view ending) {
    return is_listed(site.listed, place + std::string(ending));
  });
}

/// R2W0650 and R2W0651 go into `faults`. R2W0210 when it cannot be read at all.
Outcome<Done> check_listed(const CheckedFolder& site, const ListedFile& file, Diagnostics& faults) {
  const std::vector<std::string> places = places_of(file, site.list);
  std::vector<fs::path> parts;
  for (const std::string& place : places) {
    parts.push_back(site.folder / place);
    std::error_code error;
    const TreeEntry* entry = entry_of(site.tree, place);
    const bool there =
        (entry != nullptr && entry->kind == FileKind::kFile) ||
        (place.starts_with("../") && fs::is_regular_file(fs::symlink_status(parts.back(), error)));
    if (there) continue;
    faults.push_back(not_there(file.path));
    return Done{};
  }
  auto fault = fault_of(file, parts);
  if (!fault) return std::move(fault).errors();
  if (*fault) faults.push_back(std::move(**fault));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_whole = file.parts.empty();
    const auto wrong = wrong_form(site, places[i], is_whole ? file.size : file.parts[i].size,
                                  is_whole ? file.sha256 : file.parts[i].sha256);
    if (wrong)
      faults.push_back(
          other_bytes(file.path + *wrong, "it does not unpack to `" + file.path + "`"));
  }
  return Done{};
}

/// The address of the site's folder, with a slash at its end.
std::string folder_of(std::string url) {
  url = url.substr(0, url.find_first_of("?#"));
  if (url.ends_with('/')) return url;
  const std::size_t slash = url.rfind('/');
  const std::string_view last = std::string_view(url).substr(slash + 1);
  if (last == kSiteJsonName || last == "index.html") return url.substr(0, slash + 1);
  return url + "/";
}

/// A file that is read whole; its text is empty unless the status is 200.
struct Answer {
  int status = 0;
  std::string text;
};

Outcome<Answer> answer_of(const std::string& base, const char* name, std::uint64_t limit_bytes,
                          const ChannelNetwork& network, const fs::path& folder,
                          const Cancellation& cancellation) {
  const fs::path file = folder / name;
  auto brought = download_all(network.download,
                              {Download{.sources = {source_of(base + name, network)},
                                        .headers = {},
                                        .file = file,
                                        .limit_bytes = limit_bytes,
                                        .fault = {}}},
                              cancellation);
  if (!brought.front()) return std::move(brought.front()).errors();
  Answer answer{.status = static_cast<int>(brought.front()->status), .text = {}};
  if (answer.status != 200) return answer;
  auto text = read_file(file, limit_bytes);
  if (!text) return std::move(text).errors();
  answer.text = std::move(*text);
  return answer;
}

std::uint64_t size_of(const SiteList& list, const std::optional<ListedFile>& more) {
  std::uint64_t total = more ? more->size : 0;
  for (const ListedFile& file : list.files) total += file.size;
  return total;
}

void report(const ProgressSink& progress, std::uint64_t done, std::uint64_t total) {
  if (progress)
    progress({.step = kStep, .item = {}, .done = done, .total = total, .unit = "bytes"});
}

}  // namespace

Diagnostic unlisted_files(const std::vector<std::string>& paths, const std::string& shown) {
  constexpr std::size_t kShown = 5;
  Diagnostic warning{.code = "R2W0653",
                     .severity = Severity::kWarning,
                     .message = "`" + shown + "` has " + std::to_string(paths.size()) +
                                (paths.size() == 1 ? " file" : " files") + " that it does not list",
                     .why = {},
                     .fix = {}};
  for (std::size_t i = 0; i < paths.size() && i < kShown; ++i) warning.why.push_back(paths[i]);
  if (paths.size() > kShown)
    warning.why.push_back("and " + std::to_string(paths.size() - kShown) + " more");
  return warning;
}

Outcome<SiteCheck> check_site_folder(const fs::path& folder, const Cancellation& cancellation,
                                     const ProgressSink& progress) {
  auto text = read_file(folder / kSiteJsonName, kMostOfSiteJson);
  if (!text) return text.errors();
  auto list = read_site_list(*text, (folder / kSiteJsonName).string());
  if (!list) return std::move(list).errors();
  auto tree = list_tree(folder);
  if (!tree) return std::move(tree).errors();
  SiteCheck check{
      .list = std::move(*list), .faults = {}, .unlisted = {}, .site_json = std::move(*text)};
  for (const TreeEntry& entry : *tree) {
    if (entry.path != kSignatureName || entry.kind != FileKind::kFile) continue;
    auto signature = entry.size > kLargestSignature
                         ? Outcome<std::string>(std::string())
                         : read_file(folder / kSignatureName, kLargestSignature);
    if (!signature) return std::move(signature).errors();
    check.signature = std::move(*signature);
  }
  const std::vector<std::string> listed = listed_places(check.list);
  check.unlisted = unlisted_of(listed, *tree);
  const CheckedFolder site{.folder = folder, .list = check.list, .listed = listed, .tree = *tree};
  const auto hash_list_file = wanted_hash_list(check.list);
  std::uint64_t done = 0;
  const std::uint64_t total = size_of(check.list, hash_list_file);
  const auto look = [&](const ListedFile& file) -> Outcome<Done> {
    if (cancellation.requested()) return interrupted();
    if (auto looked = check_listed(site, file, check.faults); !looked) return looked;
    report(progress, done += file.size, total);
    return Done{};
  };
  for (const ListedFile& file : check.list.files) {
    if (auto looked = look(file); !looked) return std::move(looked).errors();
    if (check.faults.size() < kMostFaults) continue;
    check.faults.push_back(too_many_faults());
    return check;
  }
  if (hash_list_file) {
    if (auto looked = look(*hash_list_file); !looked) return std::move(looked).errors();
  }
  if (const auto wrong = wrong_form(site, kSiteJsonName, check.site_json.size(), check.list.hash))
    check.faults.push_back(other_bytes(kSiteJsonName + *wrong, "it does not unpack to site.json"));
  return check;
}

Outcome<SiteCheck> check_site_page(const fs::path& file, const Cancellation& cancellation,
                                   const ProgressSink& progress) {
  const auto page = read_file(file, kMostOfData);
  if (!page) return page.errors();
  const auto carried = read_carried_page(*page, file.string());
  if (!carried) return carried.errors();
  const auto text = unpacked(carried->files.front(), kMostOfSiteJson);
  if (!text) return text.errors();
  auto list = read_site_list(*text, file.string());
  if (!list) return std::move(list).errors();
  SiteCheck check{.list = std::move(*list), .faults = {}, .unlisted = {}, .site_json = *text};
  const std::vector<ListedFile> wanted = wanted_of(check.list);
  std::map<std::string, CarriedFile> files;
  for (const CarriedFile& one : carried->files) {
    // Browsers would take the last one, this the first.
    if (!files.emplace(one.path, one).second)
      check.faults.push_back(other_bytes(std::string(one.path), "the page has two of that name"));
  }
  if (carried->mark != carried_page_mark(check.list.generator, check.list.hash) ||
      sha256_hex(carried->bare) != check.list.carried_page_sha256)
    check.faults.push_back(other_bytes(file.filename().string(),
                                       "what stands around the site's files is not its own"));
  std::uint64_t total = 0;
  std::uint64_t done = 0;
  for (const ListedFile& one : wanted) total += one.size;
  for (const ListedFile& one : wanted) {
    if (cancellation.requested()) return interrupted();
    const auto found = files.extract(html_text(one.path));
    if (found.empty()) {
      check.faults.push_back(not_there(one.path));
      continue;
    }
    const auto bytes = unpacked(found.mapped(), one.size);
    if (!bytes) {
      check.faults.push_back(other_bytes(one.path, bytes.errors().front().why.front()));
    } else if (bytes->size() != one.size || sha256_hex(*bytes) != one.sha256) {
      check.faults.push_back(other_bytes(
          one.path, "its sha256 is " + sha256_hex(*bytes) + ", site.json says " + one.sha256));
    }
    report(progress, done += one.size, total);
  }
  for (const auto& [path, one] : files) {
    if (path == kSignatureName)
      check.signature = unpacked(one, kLargestSignature) ? *unpacked(one, kLargestSignature) : "";
    if (path != kSiteJsonName && path != kSignatureName && path != kPublicKeyName)
      check.unlisted.push_back(path);
  }
  return check;
}

Outcome<SiteCheck> check_site_address(const std::string& url, const ChannelNetwork& network,
                                      bool signature, const Cancellation& cancellation,
                                      const ProgressSink& progress) {
  const std::string base = folder_of(url);
  auto place = TemporaryDirectory::make("ros2wasm-verify-");
  if (!place) return std::move(place).errors();
  auto answer =
      answer_of(base, kSiteJsonName, kMostOfSiteJson, network, place->path(), cancellation);
  if (!answer) return std::move(answer).errors();
  if (answer->status != 200) {
    return Diagnostic{
        .code = "R2W0605",
        .message = "there is no site at " + base,
        .why = {"it has no site.json (status " + std::to_string(answer->status) + ")"},
        .fix = {}};
  }
  auto list = read_site_list(answer->text, base + kSiteJsonName);
  if (!list) return std::move(list).errors();
  SiteCheck check{
      .list = std::move(*list), .faults = {}, .unlisted = {}, .site_json = answer->text};
  if (signature) {
    auto found =
        answer_of(base, kSignatureName, kLargestSignature, network, place->path(), cancellation);
    if (!found) return std::move(found).errors();
    if (found->status == 200) check.signature = std::move(found->text);
  }
  // Files are named by their number here: what a site calls them is the site's affair.
  const std::vector<ListedFile> wanted = wanted_of(check.list);
  std::vector<Download> downloads;
  std::vector<std::vector<std::size_t>> downloads_of(wanted.size());  // more than one: of its parts
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const ListedFile& file = wanted[i];
    total += file.size;
    const std::vector<std::string> places = places_of(file, check.list);
    for (std::size_t part = 0; part < places.size(); ++part) {
      const std::uint64_t size = file.parts.empty() ? file.size : file.parts[part].size;
      downloads_of[i].push_back(downloads.size());
      downloads.push_back({.sources = {source_of(base + percent_encoded(places[part]), network)},
                           .headers = {},
                           .file = place->path() / std::to_string(downloads.size()),
                           .size = size,
                           // One more byte shows that it is larger; the rest need not come.
                           .limit_bytes = size + 1,
                           .fault = {}});
    }
  }
  auto brought =
      download_all(network.download, std::move(downloads), cancellation,
                   [&](const DownloadProgress& now) { report(progress, now.bytes, total); });
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const ListedFile& file = wanted[i];
    std::vector<fs::path> parts;
    std::optional<Diagnostic> problem;
    for (const std::size_t one : downloads_of[i]) {
      parts.push_back(place->path() / std::to_string(one));
      if (problem) continue;
      if (!brought[one]) {
        problem = std::move(brought[one]).errors().front();
        if (problem->kind == FailureKind::kInterrupted) return *problem;
        if (problem->code == "R2W0220")
          problem = other_bytes(file.path, "it has more bytes than the " +
                                               std::to_string(file.size) + " that site.json says");
      } else if (brought[one]->status != 200) {
        problem = not_there(file.path);
      }
    }
    if (!problem) {
      auto fault = fault_of(file, parts);
      if (!fault) return std::move(fault).errors();
      problem = std::move(*fault);
    }
    if (problem) check.faults.push_back(std::move(*problem));
  }
  return check;
}

}  // namespace ros2wasm
