// See store.hpp. One folder per package, named by the archive's sha256. A folder is complete when
// it has its final name: it is made beside and renamed. Two processes that make the same one do it
// twice, and one result is kept.
#include "bundler/store/store.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <utility>

#include "bundler/archive/package_lists.hpp"
#include "bundler/channel/transport.hpp"
#include "bundler/channel/verified_files.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/io/worker_pool.hpp"
#include "bundler/store/tree_seal.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostErrors = 10;
constexpr int kTickMs = 80;

Diagnostic no_archive(const PackageRecord& record) {
  return Diagnostic{.code = "R2W0228",
                    .kind = FailureKind::kEnvironment,
                    .message = "the archive of `" + distribution_name(record) + "` is not there",
                    .why = {"the channel lists it at " + record.url}};
}

struct FailedArchive {
  std::string url;
  Diagnostic error;
};

/// "https://host:8080" of "https://host:8080/channel/x.conda".
std::string server_of(const std::string& url) {
  return url.substr(0, url.find('/', url.find("://") + 3));
}

/// A network or a server that fails for one archive mostly fails for all of that server: that is
/// one error.
Diagnostics told_once(std::vector<FailedArchive> failed) {
  constexpr std::array<DiagnosticCode, 3> kOfServers{"R2W0232", "R2W0233", "R2W0235"};
  struct Group {
    std::size_t place;  ///< of the first, in what is told
    std::size_t more = 0;
  };
  std::map<std::pair<DiagnosticCode, std::string>, Group> groups;  // by code and server
  Diagnostics told;
  Diagnostics others;
  for (FailedArchive& one : failed) {
    if (std::find(kOfServers.begin(), kOfServers.end(), one.error.code) == kOfServers.end()) {
      others.push_back(std::move(one.error));
      continue;
    }
    const auto [group, is_new] =
        groups.try_emplace({one.error.code, server_of(one.url)}, Group{.place = told.size()});
    if (is_new) {
      told.push_back(std::move(one.error));
    } else {
      ++group->second.more;
    }
  }
  for (const auto& [key, group] : groups) {
    if (group.more == 0) continue;
    told[group.place].why.push_back("the same is true of " + std::to_string(group.more) +
                                    (group.more == 1 ? " more archive" : " more archives"));
  }
  for (Diagnostic& error : others) {
    if (told.size() < kMostErrors) told.push_back(std::move(error));
  }
  return told;
}

WantedFile wanted_file(const PackageRecord& record, fs::path place) {
  return {.what = "the archive of `" + distribution_name(record) + "`",
          .url = record.url,
          .place = std::move(place),
          .size = record.size,
          .sha256 = record.sha256,
          .md5 = record.md5};
}

/// The seal of a package: the hashes of the files that its own lists have no hashes for. These are
/// the files in info/, or all files of old packages.
Outcome<std::string> seal_of(const fs::path& folder) {
  const auto lists = read_package_lists(folder);
  if (!lists) return lists.errors();
  if (!lists->has_hashes()) return tree_seal(folder, {}, {});
  std::map<std::string, std::string> sums;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder / "info", error), end; !error && it != end;
       it.increment(error)) {
    const std::string name = it->path().lexically_relative(folder).generic_string();
    if (!it->is_regular_file(error)) continue;
    auto hashes = hash_file(it->path());
    if (!hashes) return std::move(hashes).errors();
    sums.emplace(name, std::move(hashes->sha256));
  }
  if (error) return cannot_read(folder / "info", error.value());
  std::string text;
  for (const auto& [name, sha256] : sums) text += sha256 + "  " + name + "\n";
  return text;
}

fs::path folder_of(const fs::path& cache, const std::string& sha256) {
  return cache / "packages" / sha256.substr(0, 2) / sha256;
}

}  // namespace

fs::path package_seal_place(const fs::path& folder) {
  return folder.string() + ".seal";
}

std::string package_fault(const fs::path& folder) {
  const auto lists = read_package_lists(folder);
  const auto entries = lists ? package_paths(*lists, folder.filename().string()) : lists.errors();
  if (!entries) return "info/paths.json is damaged";
  const auto kept = read_file(package_seal_place(folder), kMostOfList);
  const auto seal = seal_of(folder);
  if (!kept || !seal || *kept != *seal)
    return lists->has_hashes() ? "info is not as it was unpacked" : "it is not as it was unpacked";
  for (const auto& [path, entry] : *entries) {
    std::error_code error;
    const auto status = fs::symlink_status(folder / path, error);
    if (entry.kind == PathKind::kDirectory || fs::is_symlink(status)) {
      if (!fs::exists(status)) return path + " is missing";
      continue;
    }
    const auto hashes = hash_file(folder / path);
    if (!hashes) return path + " is missing";
    if (entry.size_known && hashes->size != entry.size) return path + " has another size";
    if (!entry.sha256.empty() && hashes->sha256 != ascii_lower(entry.sha256))
      return path + " has another sha256";
  }
  return {};
}

Store::Store(ChannelRoots roots, ExtractLimits limits)
    : roots_(std::move(roots)), limits_(limits) {}

fs::path Store::archive_place(const PackageRecord& record) const {
  const std::string key = record.sha256.empty() ? "md5-" + record.md5 : record.sha256;
  const char* name = record.file_name.ends_with(".conda") ? "package.conda" : "package.tar.bz2";
  return roots_.cache / "archives" / key.substr(0, 2) / key / name;
}

fs::path Store::package_place(const PackageRecord& record) const {
  return record.sha256.empty() ? fs::path() : folder_of(roots_.cache, record.sha256);
}

Outcome<std::optional<fs::path>> Store::cached(const PackageRecord& record) const {
  const fs::path folder = package_place(record);
  if (folder.empty()) return std::optional<fs::path>();
  std::error_code error;
  if (!fs::is_directory(folder, error)) return std::optional<fs::path>();
  if (package_fault(folder).empty()) return std::optional(folder);
  if (auto removed = remove_tree(folder); !removed) return std::move(removed).errors();
  return std::optional<fs::path>();
}

Outcome<fs::path> Store::unpack(const PackageRecord& record, const fs::path& archive,
                                const Cancellation& cancellation) const {
  const std::string name = distribution_name(record);
  std::string sha256 = record.sha256;
  if (sha256.empty()) {
    auto hashes = hash_file(archive);
    if (!hashes) return std::move(hashes).errors();
    sha256 = std::move(hashes->sha256);
  }
  auto beside = TemporaryDirectory::make(roots_.cache / "packages" / "unfinished",
                                         sha256.substr(0, 16) + ".");
  if (!beside) return std::move(beside).errors();
  const fs::path unfinished = beside->path() / "package";
  if (auto made = make_directories(unfinished); !made) return std::move(made).errors();
  auto unpacked = unpack_package(archive, unfinished, name, limits_, cancellation);
  if (!unpacked) return std::move(unpacked).errors();
  const auto seal = seal_of(unfinished);
  if (!seal) return seal.errors();

  fs::path folder = folder_of(roots_.cache, sha256);
  if (auto sealed = write_file(package_seal_place(folder), *seal); !sealed)
    return std::move(sealed).errors();
  std::error_code error;
  fs::rename(unfinished, folder, error);
  // Somebody else was faster: the same bytes are there.
  if (std::error_code ignored; error && !fs::is_directory(folder, ignored))
    return cannot_write(folder, error.value());
  return folder;
}

Outcome<fs::path> Store::unpack_local(const PackageRecord& record,
                                      const Cancellation& cancellation) const {
  const auto archive = local_archive(record, cancellation);
  if (!archive) return archive.errors();
  return unpack(record, *archive, cancellation);
}

Outcome<fs::path> Store::local_archive(const PackageRecord& record,
                                       const Cancellation& cancellation) const {
  auto archive = bring(record.url, roots_, cancellation);
  if (!archive) return std::move(archive).errors();
  if (!*archive) return no_archive(record);
  if (auto fault = file_fault(wanted_file(record, **archive), **archive)) return *fault;
  return std::move(**archive);
}

Outcome<std::vector<StoredArchive>> Store::archives(const std::vector<PackageRecord>& records,
                                                    const Cancellation& cancellation) const {
  std::vector<StoredArchive> archives;
  std::vector<WantedFile> wanted;
  for (const PackageRecord& record : records) {
    if (cancellation.requested()) return interrupted();
    if (is_network_url(record.url)) {
      archives.push_back({.file = archive_place(record)});
      wanted.push_back(wanted_file(record, archives.back().file));
      continue;
    }
    auto archive = local_archive(record, cancellation);
    if (!archive) return std::move(archive).errors();
    archives.push_back({.file = std::move(*archive)});
  }
  std::vector<Outcome<Done>> outcomes(wanted.size(), Outcome<Done>(Done{}));
  bring_verified(wanted, roots_.network, cancellation,
                 [&](std::size_t k, Outcome<Done> outcome) { outcomes[k] = std::move(outcome); });
  if (cancellation.requested()) return interrupted();
  std::vector<FailedArchive> failed;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (outcomes[k]) continue;
    for (Diagnostic& error : std::move(outcomes[k]).errors())
      failed.push_back({.url = wanted[k].url, .error = std::move(error)});
  }
  if (!failed.empty()) return told_once(std::move(failed));
  for (StoredArchive& archive : archives) {
    std::error_code error;
    archive.size = fs::file_size(archive.file, error);
    if (error) return cannot_read(archive.file, error.value());
  }
  return archives;
}

Outcome<std::vector<fs::path>> Store::unpacked_all(const std::vector<PackageRecord>& records,
                                                   const Cancellation& cancellation,
                                                   const ProgressSink& progress) const {
  std::vector<Outcome<fs::path>> results(records.size(), Outcome<fs::path>(fs::path()));
  std::vector<char> missing(records.size(), 0);  // each worker writes its own places only
  std::atomic<std::uint64_t> ready = 0;
  const auto report = [&] {
    if (progress) {
      progress({.step = "fetch",
                .item = {},
                .done = ready.load(),
                .total = records.size(),
                .unit = "packages"});
    }
  };
  WorkerPool pool;
  const auto wait_for_workers = [&] {
    while (!pool.wait(kTickMs)) report();
  };

  for (std::size_t i = 0; i < records.size(); ++i) {
    pool.add([&, i] {
      auto found = cancellation.requested() ? Outcome<std::optional<fs::path>>(interrupted())
                                            : cached(records[i]);
      if (!found) {
        results[i] = std::move(found).errors();
      } else if (*found) {
        results[i] = std::move(**found);
        ++ready;
      } else {
        missing[i] = 1;
      }
    });
  }
  wait_for_workers();

  std::vector<WantedFile> wanted;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (missing[i] == 0) continue;
    if (is_network_url(records[i].url)) {
      wanted.push_back(wanted_file(records[i], archive_place(records[i])));
      places.push_back(i);
      continue;
    }
    pool.add([&, i] {
      results[i] = cancellation.requested() ? Outcome<fs::path>(interrupted())
                                            : unpack_local(records[i], cancellation);
      if (results[i]) ++ready;
    });
  }
  const auto arrived = [&](std::size_t k, Outcome<Done> outcome) {
    const std::size_t i = places[k];
    if (!outcome) {
      results[i] = std::move(outcome).errors();
      return;
    }
    pool.add([&, i, k] {
      results[i] = unpack(records[i], wanted[k].place, cancellation);
      if (results[i]) ++ready;
    });
  };
  bring_verified(wanted, roots_.network, cancellation, arrived, [&](const DownloadProgress& now) {
    if (!progress) return;
    progress({.step = "download",
              .item = std::to_string(now.files) + " of " + std::to_string(wanted.size()),
              .done = now.bytes,
              .total = now.total,
              .unit = "bytes"});
  });
  wait_for_workers();

  std::vector<fs::path> folders;
  std::vector<FailedArchive> failed;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (results[i]) {
      folders.push_back(std::move(*results[i]));
      continue;
    }
    if (cancellation.requested()) return interrupted();
    for (Diagnostic& error : std::move(results[i]).errors())
      failed.push_back({.url = records[i].url, .error = std::move(error)});
  }
  if (!failed.empty()) return told_once(std::move(failed));
  report();
  return folders;
}

Outcome<fs::path> Store::unpacked(const PackageRecord& record,
                                  const Cancellation& cancellation) const {
  auto folders = unpacked_all({record}, cancellation);
  if (!folders) return std::move(folders).errors();
  return std::move(folders->front());
}

}  // namespace ros2wasm
