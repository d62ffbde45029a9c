// See store.hpp. One folder per package, named by the archive's sha256. A folder is complete when
// it has its final name: it is made beside and renamed. Two processes that make the same one do it
// twice, and one result is kept.
#include "bundler/store/store.hpp"

#include "bundler/archive/paths_json.hpp"
#include "bundler/channel/transport.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

Diagnostic wrong_archive(const PackageRecord& record, const std::string& why) {
  return Diagnostic{.code = "R2W0220",
                    .kind = FailureKind::kEnvironment,
                    .message = "the archive of `" + distribution_name(record) +
                               "` is not the one that was asked for",
                    .why = {why, "it is at " + record.url}};
}

/// sha256, or md5 in old channels, or an error when neither is known.
Outcome<std::string> verified_sha256(const PackageRecord& record, const fs::path& archive) {
  if (record.sha256.empty() && record.md5.empty()) {
    return wrong_archive(record, "its channel gives no hash, so that nobody can tell");
  }
  auto hashes = hash_file(archive, record.sha256.empty());
  if (!hashes) return std::move(hashes).errors();
  if (record.size != 0 && hashes->size != record.size) {
    return wrong_archive(record, "it has " + std::to_string(hashes->size) + " bytes instead of " +
                                     std::to_string(record.size));
  }
  if (!record.sha256.empty() && hashes->sha256 != record.sha256) {
    return wrong_archive(record,
                         "its sha256 is " + hashes->sha256 + " instead of " + record.sha256);
  }
  if (record.sha256.empty() && hashes->md5 != record.md5) {
    return wrong_archive(record, "its md5 is " + hashes->md5 + " instead of " + record.md5);
  }
  return std::move(hashes->sha256);
}

/// Every file of a package in the store has the bytes that its paths.json lists. False when one has
/// not, whatever the reason: then the package is unpacked again.
bool still_intact(const fs::path& folder, const std::string& name) {
  const auto text = read_file(folder / "info/paths.json");
  if (!text) return false;
  const auto entries = parse_paths_json(*text, name);
  if (!entries) return false;
  for (const auto& [path, entry] : *entries) {
    std::error_code error;
    const auto status = fs::symlink_status(folder / path, error);
    if (entry.kind == PathKind::kDirectory || fs::is_symlink(status)) {
      if (!fs::exists(status)) return false;
      continue;
    }
    const auto hashes = hash_file(folder / path);
    if (!hashes || (entry.size_known && hashes->size != entry.size)) return false;
    if (!entry.sha256.empty() && hashes->sha256 != ascii_lower(entry.sha256)) return false;
  }
  return true;
}

}  // namespace

fs::path default_cache_directory(const std::string& xdg_cache_home, const std::string& home) {
  if (!xdg_cache_home.empty() && fs::path(xdg_cache_home).is_absolute()) {
    return fs::path(xdg_cache_home) / "ros2wasm";
  }
  return fs::path(home.empty() ? "/tmp" : home) / ".cache" / "ros2wasm";
}

Store::Store(ChannelRoots roots, ExtractLimits limits)
    : roots_(std::move(roots)), limits_(limits) {}

Outcome<fs::path> Store::unpacked(const PackageRecord& record,
                                  const Cancellation& cancellation) const {
  const fs::path packages = roots_.cache / "packages";
  const std::string name = distribution_name(record);
  const auto folder_of = [&](const std::string& sha256) {
    return packages / sha256.substr(0, 2) / sha256;
  };
  std::error_code error;
  if (!record.sha256.empty()) {
    const fs::path folder = folder_of(record.sha256);
    if (fs::is_directory(folder, error)) {
      if (still_intact(folder, name)) return folder;
      if (auto removed = remove_tree(folder); !removed) return std::move(removed).errors();
    }
  }

  const auto archive = bring(record.url, roots_, cancellation);
  if (!archive) return archive.errors();
  if (!*archive) {
    return Diagnostic{.code = "R2W0228",
                      .kind = FailureKind::kEnvironment,
                      .message = "the archive of `" + name + "` is not there",
                      .why = {"the channel lists it at " + record.url}};
  }
  const auto sha256 = verified_sha256(record, **archive);
  if (!sha256) return sha256.errors();

  auto beside = TemporaryDirectory::make(packages / "unfinished", name + ".");
  if (!beside) return std::move(beside).errors();
  const fs::path unfinished = beside->path() / "package";
  if (auto made = make_directories(unfinished); !made) return std::move(made).errors();
  auto unpacked = unpack_package(**archive, unfinished, name, limits_, cancellation);
  if (!unpacked) return std::move(unpacked).errors();

  fs::path folder = folder_of(*sha256);
  if (auto made = make_directories(folder.parent_path()); !made) return std::move(made).errors();
  fs::rename(unfinished, folder, error);
  // Somebody else was faster: the same bytes are there.
  if (error && !fs::is_directory(folder)) return cannot_write(folder, error.value());
  return folder;
}

}  // namespace ros2wasm
