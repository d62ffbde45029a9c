// See folder_output.hpp.
#include "bundler/emit/folder_output.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "bundler/io/file_lock.hpp"
#include "bundler/io/files.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/site/site_list.hpp"
#include "bundler/site/site_path.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// A copy that whoever may read the site may read.
Outcome<Done> copy_to(const fs::path& place, const fs::path& source) {
  if (auto made = make_directories(place.parent_path()); !made) return made;
  std::error_code error;
  fs::copy_file(source, place, error);
  if (!error) {
    using enum fs::perms;
    fs::permissions(place, owner_read | owner_write | group_read | others_read, error);
  }
  if (error) return cannot_write(place, error.value());
  return Done{};
}

/// Rounds needed space up and free space down, so that the printed numbers show that something does
/// not fit.
std::string megabytes(std::uint64_t bytes, bool is_needed) {
  const std::uint64_t tenths = (bytes + (is_needed ? 99'999 : 0)) / 100'000;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " MB";
}

/// Puts `fresh` in the place of `folder` in one step; what was there ends up at `fresh`.
int swap_folders(const fs::path& fresh, const fs::path& folder) {
  if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0)
    return 0;
  // Some file systems cannot exchange: move the old one aside first.
  const fs::path aside = fresh.string() + ".old";
  if (::rename(folder.c_str(), aside.c_str()) != 0) return errno;
  if (::rename(fresh.c_str(), folder.c_str()) == 0) {
    ::rename(aside.c_str(), fresh.c_str());
    return 0;
  }
  const int failure = errno;
  ::rename(aside.c_str(), folder.c_str());
  return failure;
}

/// A new folder beside the site, which is written there first, and a lock that tells that somebody
/// writes in it.
struct Beside {
  TemporaryDirectory folder;
  std::optional<FileLock> lock;
};

std::string beside_prefix(const fs::path& clean) {
  constexpr std::size_t kMostOfName = 200;  // the rest of what a name may have is for the ending
  return "." + clean.filename().string().substr(0, kMostOfName) + "-new-";
}

/// Some file systems lock no folders: then there is no lock, and nothing is swept away.
Outcome<Beside> make_beside(const fs::path& clean) {
  constexpr int kTries = 4;  // one may be swept away before it is locked
  for (int i = 1;; ++i) {
    auto folder = TemporaryDirectory::make(clean.parent_path(), beside_prefix(clean));
    if (!folder) return std::move(folder).errors();
    auto lock = FileLock::of_folder(folder->path());
    std::error_code error;
    if ((lock && fs::exists(folder->path(), error)) || i == kTries)
      return Beside{.folder = std::move(*folder), .lock = std::move(lock)};
  }
}

/// Removes what packs left beside the site that were killed.
void sweep_beside(const fs::path& clean) {
  const std::string prefix = beside_prefix(clean);
  constexpr std::size_t kRandomLetters = 6;  // of mkdtemp()
  std::vector<fs::path> left;
  std::error_code error;
  for (fs::directory_iterator it(clean.parent_path(), error), end; !error && it != end;
       it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.size() == prefix.size() + kRandomLetters && name.starts_with(prefix))
      left.push_back(it->path());
  }
  for (const fs::path& folder : left) {
    if (const auto nobody_writes = FileLock::of_folder(folder)) (void)remove_tree(folder);
  }
}

/// Keeps the previous site beside the new one, for links that name it. `old` is its folder now.
void keep_earlier(const fs::path& old, const fs::path& site, const std::string& sha256) {
  const auto text = read_file(old / kSiteJsonName, kMostOfSiteJson);
  if (!text) return;
  const auto list = read_site_list(*text, kSiteJsonName);
  if (!list || list->store.objects.empty() || list->hash == sha256) return;
  const fs::path place = site.parent_path() / earlier_folder(site.filename().string(), list->hash);
  std::error_code error;
  if (!fs::exists(fs::symlink_status(place, error))) fs::rename(old, place, error);
}

/// The store of the site, marked as one of ours. Until the site is in its place nobody may take
/// away what it has in the store. Nothing when it has none.
Outcome<std::optional<FileLock>> open_store(const SitePlan& plan, const fs::path& clean,
                                            const Cancellation& cancellation) {
  if (plan.store.objects.empty()) return std::optional<FileLock>();
  const fs::path store = (clean / plan.store.objects).lexically_normal();
  if (auto written = write_file(store / kStoreMarker, kStoreMarkerText); !written)
    return std::move(written).errors();
  return FileLock::take_folder(store, true, cancellation);
}

/// `folder`: what the site is in now, `clean`: where it will be.
Outcome<Done> write_planned(const SitePlan& plan, const fs::path& folder, const fs::path& clean,
                            const Cancellation& cancellation) {
  for (const PlannedFile& file : plan.files) {
    if (auto refusal = refuse_site_path(file.path)) return *refusal;
    std::size_t at = 0;
    std::size_t number = 0;
    for (const std::string& place : places_of(file, plan)) {
      if (cancellation.requested()) return interrupted();
      const std::size_t size = file.parts.empty()
                                   ? file.bytes.size()
                                   : static_cast<std::size_t>(file.parts[number++].size);
      // The store's come first in time: no site names what is not there.
      const fs::path& base = place.starts_with("../") ? clean : folder;
      auto written = write_file((base / place).lexically_normal(),
                                std::string_view(file.bytes).substr(at, size));
      if (!written) return written;
      at += size;
    }
  }
  return Done{};
}

}  // namespace

std::string earlier_folder(const std::string& name, const std::string& sha256) {
  constexpr std::size_t kDigits = 16;
  return name + "@" + sha256.substr(0, kDigits);
}

std::optional<Diagnostic> refuse_folder(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) {
    if (!fs::is_symlink(fs::symlink_status(folder, error))) return std::nullopt;
    return Diagnostic{.code = "R2W0601",
                      .message = "`" + folder.string() + "` is a link that leads nowhere",
                      .why = {"a site is written where a link leads, and there is no such folder"},
                      .fix = {"make the folder, remove the link, or choose another place with -o"}};
  }
  if (fs::is_directory(status) && (fs::is_empty(folder, error) || is_site_of_ours(folder)))
    return std::nullopt;
  return Diagnostic{
      .code = "R2W0601",
      .message = "`" + folder.string() + "` exists and is not a site made by ros2wasm",
      .why = {fs::is_directory(status) ? "writing a site there would remove what is in it; it has "
                                         "no site.json that ros2wasm wrote"
                                       : "it is not a folder"},
      .fix = {"choose another place with -o"}};
}

std::optional<Diagnostic> refuse_size(const fs::path& folder, std::uint64_t needed,
                                      std::uint64_t available) {
  if (needed <= available) return std::nullopt;
  return Diagnostic{.code = "R2W0602",
                    .kind = FailureKind::kEnvironment,
                    .message = "there is not enough space for the site at " + folder.string(),
                    .why = {"the site needs " + megabytes(needed, true) + ", the disk has " +
                            megabytes(available, false) + " left"}};
}

Outcome<Done> emit_folder(const SitePlan& plan, const fs::path& folder,
                          const Cancellation& cancellation) {
  if (auto refusal = refuse_folder(folder)) return *refusal;
  std::error_code error;
  // A link to the folder stays a link: what it leads to is replaced.
  const auto whole = absolute_path(folder);
  if (!whole) return whole.errors();
  const fs::path place =
      fs::exists(folder, error) ? fs::canonical(folder, error) : whole->lexically_normal();
  if (error) return cannot_write(folder, error.value());
  const fs::path clean = place.has_filename() ? place : place.parent_path();
  if (auto made = make_directories(clean.parent_path()); !made) return made;
  const fs::space_info space = fs::space(clean.parent_path(), error);
  // One such as /proc says that it has no space at all; that it takes no files is the reason then.
  if (!error && space.capacity != 0) {
    if (auto refusal = refuse_size(folder, total_size(plan) + channel_size(plan), space.available))
      return *refusal;
  }
  sweep_beside(clean);
  auto made = make_beside(clean);
  if (!made) return std::move(made).errors();
  const TemporaryDirectory* const beside = &made->folder;
  const auto store = open_store(plan, clean, cancellation);
  if (!store) return store.errors();
  if (auto written = write_planned(plan, beside->path(), clean, cancellation); !written)
    return written;
  for (const ChannelFile& file : plan.channel) {
    if (cancellation.requested()) return interrupted();
    if (auto refusal = refuse_site_path(file.path)) return *refusal;
    const fs::path place_of_file = beside->path() / file.path;
    auto written = file.copy_of.empty() ? write_file(place_of_file, file.bytes)
                                        : copy_to(place_of_file, file.copy_of);
    if (!written) return written;
  }
  ::chmod(beside->path().c_str(), 0755);  // temporary folders are private, sites are not
  const bool replaces = fs::exists(clean, error);
  // It will lie beside for a moment, and is nobody's to sweep away.
  const auto old = FileLock::of_folder(clean, true);
  int failure = 0;
  if (replaces) {
    failure = swap_folders(beside->path(), clean);
  } else if (::rename(beside->path().c_str(), clean.c_str()) != 0) {
    failure = errno;
  }
  if (failure != 0) return cannot_write(folder, failure);
  if (replaces && !plan.store.objects.empty()) keep_earlier(beside->path(), clean, plan.sha256);
  return Done{};
}

}  // namespace ros2wasm
