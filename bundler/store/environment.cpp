// See environment.hpp.
#include "bundler/store/environment.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <map>

#include "bundler/archive/package_lists.hpp"
#include "bundler/io/cached_folder.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/store/prefix_text.hpp"
#include "bundler/store/python_packages.hpp"
#include "bundler/store/tree_seal.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLayout = "2";  // changes when the layout of environments changes

/// Another file system, too many links already, or a file system that has none.
bool cannot_be_linked(const std::error_code& error) {
  return error == std::errc::cross_device_link || error == std::errc::too_many_links ||
         error == std::errc::operation_not_permitted;
}

/// Puts package after package into one prefix.
class Installer {
 public:
  /// `site_packages`: see python_packages.hpp.
  Installer(fs::path staging, fs::path prefix, std::string site_packages)
      : staging_(std::move(staging)),
        prefix_(std::move(prefix)),
        site_packages_(std::move(site_packages)) {}

  Outcome<Done> install(const PackageRecord& record, const fs::path& package) {
    const auto lists = read_package_lists(package);
    if (!lists) return lists.errors();
    auto entries = package_paths(*lists, distribution_name(record));
    if (!entries) return std::move(entries).errors();
    if (!lists->has_hashes()) without_hashes_.push_back(distribution_name(record));
    for (auto& [path, entry] : *entries) {
      std::error_code error;
      const auto status = fs::symlink_status(package / path, error);
      if (fs::is_regular_file(status) && entry.sha256.empty()) {
        auto hashes = hash_file(package / path);
        if (!hashes) return std::move(hashes).errors();
        entry.sha256 = std::move(hashes->sha256);
      }
      if (auto placed = place(record, package, path, entry); !placed) return placed;
    }
    return Done{};
  }

  std::vector<std::string> take_without_hashes() { return std::move(without_hashes_); }

  std::vector<OverwrittenFile> take_overwritten() {
    std::sort(overwritten_.begin(), overwritten_.end(),
              [](const OverwrittenFile& a, const OverwrittenFile& b) { return a.path < b.path; });
    return std::move(overwritten_);
  }

 private:
  Outcome<Done> place(const PackageRecord& record, const fs::path& package,
                      const std::string& packed_path, const PathEntry& entry) {
    const fs::path source = package / packed_path;
    const std::string path = record.noarch == NoarchKind::kPython
                                 ? path_in_prefix(packed_path, site_packages_)
                                 : packed_path;
    const fs::path target = staging_ / path;
    if (entry.kind == PathKind::kDirectory) return make_folder(record, path);
    if (auto made = make_folder(record, fs::path(path).parent_path()); !made) return made;
    if (const auto folder = folders_.find(path); folder != folders_.end())
      return not_together(folder->second, distribution_name(record), path);
    if (auto cleared = clear(record, path, entry.sha256); !cleared) return cleared;
    owners_[path] = {distribution_name(record), entry.sha256};
    std::error_code error;
    if (fs::is_symlink(fs::symlink_status(source, error))) {
      fs::copy_symlink(source, target, error);
    } else if (entry.mode == PrefixMode::kNone) {
      fs::create_hard_link(source, target, error);
      if (cannot_be_linked(error)) {
        error.clear();
        fs::copy_file(source, target, error);
      }
    } else {
      return place_with_prefix(source, target, path, entry);
    }
    if (error) return cannot_write(target, error.value());
    return Done{};
  }

  /// Every part of `path` becomes a real folder. A link that stays inside its own package may lead
  /// anywhere once another package's link stands on its way, so nothing is written through one.
  Outcome<Done> make_folder(const PackageRecord& record, const fs::path& path) {
    if (path.empty() || folders_.contains(path)) return Done{};
    if (auto above = make_folder(record, path.parent_path()); !above) return above;
    const fs::path target = staging_ / path;
    std::error_code error;
    switch (fs::symlink_status(target, error).type()) {
      case fs::file_type::directory:
        break;
      case fs::file_type::not_found:
        fs::create_directory(target, error);
        if (error) return cannot_write(target, error.value());
        break;
      default:
        return no_folder(record, path);
    }
    folders_.emplace(path, distribution_name(record));
    return Done{};
  }

  [[nodiscard]] Diagnostic no_folder(const PackageRecord& record, const fs::path& path) const {
    const auto owner = owners_.find(path.string());
    return not_together(distribution_name(record),
                        owner == owners_.end() ? "another package" : owner->second.name, path);
  }

  [[nodiscard]] static Diagnostic not_together(const std::string& folder_of,
                                               const std::string& file_of, const fs::path& path) {
    return Diagnostic{
        .code = "R2W0231",
        .kind = FailureKind::kEnvironment,
        .message = "`" + folder_of + "` and `" + file_of + "` cannot be installed together",
        .why = {"`" + path.string() + "` is a folder in the first, but a file or a " +
                "link in the second"}};
  }

  /// Later packages win; a file with other bytes is remembered.
  Outcome<Done> clear(const PackageRecord& record, const std::string& path,
                      const std::string& sha256) {
    const auto owner = owners_.find(path);
    if (owner == owners_.end()) return Done{};
    if (owner->second.sha256 != sha256) {
      overwritten_.push_back(
          {.path = path, .winner = distribution_name(record), .loser = owner->second.name});
    }
    return remove_tree(staging_ / path);
  }

  Outcome<Done> place_with_prefix(const fs::path& source, const fs::path& target,
                                  const std::string& path, const PathEntry& entry) {
    const auto bytes = read_file(source, kMostOfData);
    if (!bytes) return bytes.errors();
    Outcome<std::string> moved =
        entry.mode == PrefixMode::kText
            ? Outcome<std::string>(with_prefix_in_text(*bytes, entry.placeholder, prefix_.string()))
            : with_prefix_in_binary(*bytes, entry.placeholder, prefix_.string(), path);
    if (!moved) return std::move(moved).errors();
    if (auto written = write_file(target, *moved); !written) return written;
    std::error_code error;
    fs::permissions(target, fs::status(source, error).permissions(), error);
    if (error) return cannot_write(target, error.value());
    return Done{};
  }

  struct Owner {
    std::string name;
    std::string sha256;
  };
  fs::path staging_;
  fs::path prefix_;  ///< where it will be
  std::string site_packages_;
  std::map<std::string, Owner> owners_;
  std::map<fs::path, std::string> folders_;  ///< and who brought them first; they stay folders
  std::vector<OverwrittenFile> overwritten_;
  std::vector<std::string> without_hashes_;
};

Outcome<Environment> build(const fs::path& staging, const fs::path& prefix, const Store& store,
                           const std::vector<PackageRecord>& records,
                           const Cancellation& cancellation, const ProgressSink& progress) {
  const auto packages = store.unpacked_all(records, cancellation, progress);
  if (!packages) return packages.errors();
  auto site_packages = site_packages_of(records, *packages);
  if (!site_packages) return std::move(site_packages).errors();
  Installer installer(staging, prefix, std::move(*site_packages));
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (cancellation.requested()) return interrupted();
    if (auto installed = installer.install(records[i], (*packages)[i]); !installed)
      return std::move(installed).errors();
  }
  return Environment{.prefix = prefix,
                     .key = environment_key(records),
                     .overwritten = installer.take_overwritten(),
                     .without_hashes = installer.take_without_hashes()};
}

}  // namespace

std::string environment_key(const std::vector<PackageRecord>& records) {
  Hasher hasher;
  hasher.add(kLayout);
  for (const PackageRecord& record : records) {
    hasher.add("\n" + distribution_name(record) + " " + record.sha256 + " " + record.md5);
  }
  return hasher.hex();
}

Outcome<Environment> make_environment(const Store& store, const std::vector<PackageRecord>& records,
                                      const Cancellation& cancellation,
                                      const ProgressSink& progress) {
  const std::string key = environment_key(records);
  const fs::path folder = store.roots().cache / "environments";
  const fs::path prefix = folder / key.substr(0, 32);
  const fs::path seal_file = prefix.string() + ".seal";
  if (is_kept(prefix, key)) {
    const auto is = tree_seal(prefix, kKeptStamp, cancellation);
    if (!is && cancellation.requested()) return is.errors();
    const auto was = read_file(seal_file, kMostOfData);
    if (is && was && *is == *was)
      return Environment{
          .prefix = prefix, .key = key, .overwritten = {}, .without_hashes = {}, .cached = true};
    if (auto removed = remove_tree(prefix); !removed) return std::move(removed).errors();
  }
  auto beside = TemporaryDirectory::make(folder / "unfinished", key.substr(0, 8) + ".");
  if (!beside) return std::move(beside).errors();
  const fs::path staging = beside->path() / "prefix";
  if (auto made = make_directories(staging); !made) return std::move(made).errors();
  auto environment = build(staging, prefix, store, records, cancellation, progress);
  if (!environment) return environment;
  const auto seal = tree_seal(staging, kKeptStamp, cancellation);
  if (!seal) return seal.errors();
  if (auto kept = write_file(seal_file, *seal); !kept) return std::move(kept).errors();
  if (auto kept = keep_folder(staging, prefix, key); !kept) return std::move(kept).errors();
  return environment;
}

}  // namespace ros2wasm
