// See cache_care.hpp.
#include "bundler/store/cache_care.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <set>

#include "bundler/channel/cached_index.hpp"
#include "bundler/channel/index_cache.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/io/worker_pool.hpp"
#include "bundler/store/build_place.hpp"
#include "bundler/store/source_trees.hpp"
#include "bundler/store/store.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::hours kLeftoverAge{1};
/// The age limit, counted from the last use.
constexpr std::chrono::hours kKeptLaunchAge{30 * 24};

/// The direct entries of a folder, sorted; empty when the folder is missing.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    entries.push_back(it->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// The folders of `<area>/<two letters>/`.
std::vector<fs::path> in_buckets(const fs::path& area) {
  std::vector<fs::path> found;
  for (const fs::path& bucket : entries_of(area)) {
    if (bucket.filename().string().size() != 2) continue;
    const auto entries = entries_of(bucket);
    found.insert(found.end(), entries.begin(), entries.end());
  }
  return found;
}

bool is_leftover_name(const fs::path& path) {
  return path.filename().string().find(".part") != std::string::npos;
}

std::uint64_t bytes_of(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(fs::symlink_status(path, error))) return fs::file_size(path, error);
  std::uint64_t bytes = 0;
  for (fs::recursive_directory_iterator it(path, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code ignored;
    if (it->is_regular_file(ignored) && !it->is_symlink(ignored)) bytes += it->file_size(ignored);
  }
  return bytes;
}

/// Something with a hash, and what is wrong with it.
struct Item {
  fs::path path;
  std::string (*fault)(const fs::path&);
};

std::string fault_of_archive(const fs::path& file) {
  const std::string key = file.parent_path().filename().string();
  const bool md5 = key.starts_with("md5-");
  const auto hashes = hash_file(file, md5);
  if (!hashes) return "it cannot be read";
  if (md5) return "md5-" + hashes->md5 == key ? "" : "it has another md5";
  return hashes->sha256 == key ? "" : "it has another sha256";
}

std::string fault_of_shard(const fs::path& file) {
  const auto hashes = hash_file(file);
  if (!hashes) return "it cannot be read";
  return file.filename().string().starts_with(hashes->sha256 + ".") ? "" : "it has another sha256";
}

/// `state` is the state.json of an index.
std::optional<IndexCopyState> state_at(const fs::path& state) {
  const auto text = read_file(state, kMostOfList);
  return text ? read_copy_state(*text) : std::nullopt;
}

std::string fault_of_index(const fs::path& folder) {
  const auto state = state_at(folder / "state.json");
  if (!state) return "state.json cannot be read";
  if (state->sha256.empty()) return {};
  const auto hashes = hash_file(index_copy_place(folder, *state));
  return hashes && hashes->sha256 == state->sha256 ? "" : "the copy has another sha256";
}

/// Beside the folders of packages lie their seals, and what is left of writing one.
bool is_package(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(fs::symlink_status(path, error));
}

bool is_kept_index(const fs::path& path) {
  return path.extension() == ".index";
}

std::string fault_of_kept_index(const fs::path& file) {
  const auto mapped = MappedFile::open(file);
  if (!mapped) return "it cannot be read";
  const auto source = kept_source(mapped->bytes());
  const auto index = source ? KeptIndex::open(mapped->bytes(), *source) : std::nullopt;
  if (!index) return "it is damaged, or another version of ros2wasm wrote it";
  for (std::size_t name = 0; name < index->names().size(); ++name) {
    if (!index->records(name)) return "it is damaged";
  }
  return {};
}

/// Kept indexes of copies that are still used. Those of channels on this machine are not known;
/// they are made again in a moment.
std::set<fs::path> used_kept_indexes(const fs::path& cache) {
  std::set<fs::path> used;
  for (const fs::path& folder : entries_of(cache / "index")) {
    const auto state = state_at(folder / "state.json");
    if (!state) continue;
    const fs::path copy = index_copy_place(folder, *state);
    const fs::path kept = kept_index_place(cache, copy);
    const auto mapped = MappedFile::open(kept);
    const auto is = identity_of(copy);
    if (mapped && is && kept_source(mapped->bytes()) == *is) used.insert(kept);
  }
  return used;
}

std::vector<Item> items_of(const fs::path& cache) {
  std::vector<Item> items;
  for (const fs::path& folder : in_buckets(cache / "packages")) {
    if (is_package(folder)) items.push_back({folder, package_fault});
  }
  for (const fs::path& folder : in_buckets(cache / "archives")) {
    for (const fs::path& file : entries_of(folder)) {
      if (!is_leftover_name(file)) items.push_back({file, fault_of_archive});
    }
  }
  for (const fs::path& file : in_buckets(cache / "shards")) {
    if (!is_leftover_name(file)) items.push_back({file, fault_of_shard});
  }
  for (const fs::path& folder : in_buckets(cache / "sources")) {
    if (is_package(folder)) items.push_back({folder, source_fault});
  }
  for (const fs::path& folder : entries_of(cache / "index")) {
    std::error_code error;
    if (is_kept_index(folder)) items.push_back({folder, fault_of_kept_index});
    if (fs::exists(folder / "state.json", error)) items.push_back({folder, fault_of_index});
  }
  return items;
}

class Pruner {
 public:
  explicit Pruner(const Cancellation& cancellation) : cancellation_(cancellation) {}

  void remove(const fs::path& path) {
    if (cancellation_.requested() || !failures_.empty()) return;
    const std::uint64_t bytes = bytes_of(path);
    if (auto removed = remove_tree(path); !removed) {
      failures_ = std::move(removed).errors();
      return;
    }
    ++pruned_.entries;
    pruned_.bytes += bytes;
  }

  void remove_if_old(const fs::path& path, std::chrono::hours most = kLeftoverAge) {
    std::error_code error;
    const auto age = fs::file_time_type::clock::now() - fs::last_write_time(path, error);
    if (!error && age > most) remove(path);
  }

  Outcome<Pruned> end() {
    if (cancellation_.requested()) return interrupted();
    if (!failures_.empty()) return std::move(failures_);
    return pruned_;
  }

 private:
  const Cancellation& cancellation_;
  Pruned pruned_;
  Diagnostics failures_;
};

}  // namespace

Outcome<Done> mark_cache(const fs::path& cache) {
  if (auto written = write_file(cache / "COLCON_IGNORE", ""); !written) return written;
  return write_file(cache / "package.json", "{\"type\": \"commonjs\"}\n");
}

Outcome<std::vector<CacheArea>> measure_cache(const fs::path& cache) {
  std::vector<CacheArea> areas;
  for (const fs::path& folder : entries_of(cache)) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) continue;
    CacheArea area{.name = folder.filename().string()};
    fs::recursive_directory_iterator it(folder, error);
    for (const fs::recursive_directory_iterator end; !error && it != end; it.increment(error)) {
      std::error_code ignored;
      if (it->is_symlink(ignored) || !it->is_regular_file(ignored)) continue;
      ++area.files;
      area.bytes += it->file_size(ignored);
    }
    if (error) return cannot_read(folder, error.value());
    areas.push_back(std::move(area));
  }
  return areas;
}

Outcome<CacheCheck> check_cache(const fs::path& cache, const Cancellation& cancellation) {
  const std::vector<Item> items = items_of(cache);
  CacheCheck check{.checked = items.size(), .faults = {}};
  std::mutex mutex;
  {
    WorkerPool pool;
    for (const Item& item : items) {
      pool.add([&] {
        if (cancellation.requested()) return;
        std::string fault = item.fault(item.path);
        if (fault.empty()) return;
        const std::scoped_lock lock(mutex);
        check.faults.push_back({.path = item.path.lexically_relative(cache).generic_string(),
                                .reason = std::move(fault)});
      });
    }
  }
  if (cancellation.requested()) return interrupted();
  std::sort(check.faults.begin(), check.faults.end(),
            [](const CacheFault& a, const CacheFault& b) { return a.path < b.path; });
  return check;
}

Outcome<Pruned> prune_cache(const fs::path& cache, const PruneRequest& request,
                            const Cancellation& cancellation) {
  Pruner pruner(cancellation);
  if (request.everything) {
    for (const fs::path& entry : entries_of(cache)) {
      std::error_code error;
      if (fs::is_directory(entry, error)) pruner.remove(entry);
    }
    return pruner.end();
  }
  const auto check = check_cache(cache, cancellation);
  if (!check) return check.errors();
  for (const CacheFault& fault : check->faults) pruner.remove(cache / fault.path);
  for (const fs::path& entry : in_buckets(cache / "packages")) {
    fs::path folder = entry;
    folder.replace_extension();
    const bool is_seal = entry == package_seal_place(folder) && is_package(folder);
    if (!is_package(entry) && !is_seal) pruner.remove_if_old(entry);
  }
  for (const fs::path& entry : entries_of(build_area(cache))) {
    if (entry != build_place(cache)) pruner.remove(entry);
  }
  for (const auto& [area, kept] : {std::pair(launch_area(cache), kept_launch_place(cache)),
                                   {python_area(cache), kept_python_place(cache)}}) {
    for (const fs::path& entry : entries_of(area)) {
      if (entry != kept) pruner.remove(entry);
    }
    for (const fs::path& file : entries_of(kept))
      pruner.remove_if_old(file, is_leftover_name(file) ? kLeftoverAge : kKeptLaunchAge);
  }
  for (const fs::path& entry : in_buckets(cache / "sources")) {
    fs::path folder = entry;
    folder.replace_extension();
    if (!is_package(entry) && !is_package(folder)) pruner.remove_if_old(entry);
  }
  for (const char* area : {"packages", "environments", "index", "sources"}) {
    for (const fs::path& entry : entries_of(cache / area / "unfinished"))
      pruner.remove_if_old(entry);
  }
  for (const fs::path& folder : in_buckets(cache / "archives")) {
    std::error_code error;
    const std::string key = folder.filename().string();
    if (fs::is_directory(cache / "packages" / key.substr(0, 2) / key, error) ||
        fs::is_directory(source_place(cache, key), error))
      pruner.remove(folder);
  }
  for (const char* area : {"archives", "shards"}) {
    for (const fs::path& entry : in_buckets(cache / area)) {
      if (is_leftover_name(entry)) pruner.remove_if_old(entry);
      for (const fs::path& file : entries_of(entry)) {
        if (is_leftover_name(file)) pruner.remove_if_old(file);
      }
    }
  }
  const std::set<fs::path> used = used_kept_indexes(cache);
  for (const fs::path& folder : entries_of(cache / "index")) {
    std::error_code error;
    if (fs::is_regular_file(folder, error)) {  // a kept index, or what is left of writing one
      if (!is_kept_index(folder)) pruner.remove_if_old(folder);
      if (is_kept_index(folder) && !used.contains(folder)) pruner.remove(folder);
    }
    const auto state = state_at(folder / "state.json");
    if (!state) continue;
    for (const fs::path& file : entries_of(folder)) {
      if (file.filename() != "state.json" && file != index_copy_place(folder, *state))
        pruner.remove(file);
    }
  }
  return pruner.end();
}

}  // namespace ros2wasm
