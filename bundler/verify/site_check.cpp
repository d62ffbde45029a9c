// See site_check.hpp.
#include "bundler/verify/site_check.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/plan/shipped_channel.hpp"
#include "bundler/plan/site_plan.hpp"
#include "bundler/render/carried_page.hpp"
#include "bundler/render/html_text.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestSiteJson = std::uint64_t{64} << 20;
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

/// Nothing when the file has the listed bytes. R2W0210 when it cannot be read at all.
Outcome<std::optional<Diagnostic>> fault_of(const ListedFile& listed, const fs::path& file) {
  const auto hashes = hash_file(file);
  if (!hashes) return hashes.errors();
  if (hashes->size != listed.size) {
    return std::optional(other_bytes(listed.path, "it has " + std::to_string(hashes->size) +
                                                      " bytes, site.json says " +
                                                      std::to_string(listed.size)));
  }
  if (hashes->sha256 != listed.sha256) {
    return std::optional(other_bytes(
        listed.path, "its sha256 is " + hashes->sha256 + ", site.json says " + listed.sha256));
  }
  return std::optional<Diagnostic>();
}

/// What no site.json lists, apart from itself and the channel that may lie beside a site.
std::vector<std::string> unlisted_of(const SiteList& list, const std::vector<TreeEntry>& tree) {
  std::set<std::string> listed{kSiteJsonName, kHashList};
  for (const ListedFile& file : list.files) listed.insert(file.path);
  std::vector<std::string> result;
  for (const TreeEntry& entry : tree) {
    if (entry.kind == FileKind::kDirectory || listed.contains(entry.path) ||
        entry.path.starts_with(std::string(kShippedChannel) + "/"))
      continue;
    result.push_back(entry.path);
  }
  return result;
}

std::string percent_encoded(std::string_view path) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  constexpr std::string_view kPlain = "-._~/!$&'()*+,;=:@";
  std::string result;
  for (const char letter : path) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool alphanumeric = (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') ||
                              (byte >= 'A' && byte <= 'Z');
    if (alphanumeric || kPlain.find(letter) != std::string_view::npos) {
      result += letter;
    } else {
      result += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
    }
  }
  return result;
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

void report(const ProgressSink& progress, std::uint64_t done, std::uint64_t total) {
  if (progress)
    progress({.step = kStep, .item = {}, .done = done, .total = total, .unit = "bytes"});
}

}  // namespace

Outcome<SiteCheck> check_site_folder(const fs::path& folder, const Cancellation& cancellation,
                                     const ProgressSink& progress) {
  const auto text = read_file(folder / kSiteJsonName);
  if (!text) return text.errors();
  auto list = read_site_list(*text, (folder / kSiteJsonName).string());
  if (!list) return std::move(list).errors();
  auto tree = list_tree(folder);
  if (!tree) return std::move(tree).errors();
  std::set<std::string> files;
  for (const TreeEntry& entry : *tree) {
    if (entry.kind == FileKind::kFile) files.insert(entry.path);
  }
  SiteCheck check{.list = std::move(*list), .faults = {}, .unlisted = {}};
  check.unlisted = unlisted_of(check.list, *tree);
  std::vector<ListedFile> wanted = check.list.files;
  wanted.push_back(listed_hash_list(check.list));
  std::uint64_t total = 0;
  std::uint64_t done = 0;
  for (const ListedFile& file : wanted) total += file.size;
  for (const ListedFile& file : wanted) {
    if (cancellation.requested()) return interrupted();
    if (!files.contains(file.path)) {
      check.faults.push_back(not_there(file.path));
    } else {
      auto fault = fault_of(file, folder / file.path);
      if (!fault) return std::move(fault).errors();
      if (*fault) check.faults.push_back(std::move(**fault));
    }
    report(progress, done += file.size, total);
  }
  return check;
}

Outcome<SiteCheck> check_site_page(const fs::path& file, const Cancellation& cancellation,
                                   const ProgressSink& progress) {
  const auto page = read_file(file);
  if (!page) return page.errors();
  const auto carried = read_carried_page(*page, file.string());
  if (!carried) return carried.errors();
  const auto text = unpacked(carried->files.front(), kLargestSiteJson);
  if (!text) return text.errors();
  auto list = read_site_list(*text, file.string());
  if (!list) return std::move(list).errors();
  SiteCheck check{.list = std::move(*list), .faults = {}, .unlisted = {}};
  std::vector<ListedFile> wanted = check.list.files;
  wanted.push_back(listed_hash_list(check.list));
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
    if (path != kSiteJsonName) check.unlisted.push_back(path);
  }
  return check;
}

Outcome<SiteCheck> check_site_address(const std::string& url, const ChannelNetwork& network,
                                      const Cancellation& cancellation,
                                      const ProgressSink& progress) {
  const std::string base = folder_of(url);
  auto place = TemporaryDirectory::make(fs::temp_directory_path(), "ros2wasm-verify-");
  if (!place) return std::move(place).errors();
  const fs::path site_json = place->path() / kSiteJsonName;
  auto first = download_all(network.download,
                            {Download{.sources = {source_of(base + kSiteJsonName, network)},
                                      .headers = {},
                                      .file = site_json,
                                      .limit_bytes = kLargestSiteJson,
                                      .fault = {}}},
                            cancellation);
  if (!first.front()) return std::move(first.front()).errors();
  if (first.front()->status != 200) {
    return Diagnostic{
        .code = "R2W0605",
        .message = "there is no site at " + base,
        .why = {"it has no site.json (status " + std::to_string(first.front()->status) + ")"},
        .fix = {}};
  }
  const auto text = read_file(site_json);
  if (!text) return text.errors();
  auto list = read_site_list(*text, base + kSiteJsonName);
  if (!list) return std::move(list).errors();
  SiteCheck check{.list = std::move(*list), .faults = {}, .unlisted = {}};
  // Files are named by their number here: what a site calls them is the site's affair.
  std::vector<ListedFile> wanted = check.list.files;
  wanted.push_back(listed_hash_list(check.list));
  std::vector<Download> downloads;
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const ListedFile& file = wanted[i];
    total += file.size;
    downloads.push_back({.sources = {source_of(base + percent_encoded(file.path), network)},
                         .headers = {},
                         .file = place->path() / std::to_string(i),
                         .size = file.size,
                         // One more byte shows that it is larger; the rest need not come.
                         .limit_bytes = file.size + 1,
                         .fault = {}});
  }
  auto brought =
      download_all(network.download, std::move(downloads), cancellation,
                   [&](const DownloadProgress& now) { report(progress, now.bytes, total); });
  for (std::size_t i = 0; i < brought.size(); ++i) {
    const ListedFile& file = wanted[i];
    if (!brought[i]) {
      Diagnostic error = std::move(brought[i]).errors().front();
      if (error.kind == FailureKind::kInterrupted) return error;
      if (error.code == "R2W0220")
        error = other_bytes(file.path, "it has more bytes than the " + std::to_string(file.size) +
                                           " that site.json says");
      check.faults.push_back(std::move(error));
      continue;
    }
    if (brought[i]->status != 200) {
      check.faults.push_back(not_there(file.path));
      continue;
    }
    auto fault = fault_of(file, place->path() / std::to_string(i));
    if (!fault) return std::move(fault).errors();
    if (*fault) check.faults.push_back(std::move(**fault));
  }
  return check;
}

}  // namespace ros2wasm
