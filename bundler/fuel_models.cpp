// See fuel_models.hpp.
#include "bundler/fuel_models.hpp"

#include <algorithm>
#include <set>
#include <system_error>

#include "bundler/channel/verified_files.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/store/cache_care.hpp"
#include "bundler/workspace/fuel_needs.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// A model may name others without end.
constexpr std::size_t kMostModels = 200;
constexpr std::uint64_t kMostOfArchive = std::uint64_t{1} << 30U;
/// Fuel's way to say which version the newest one is.
constexpr const char* kVersionHeader = "x-ign-resource-version";
/// A site that carries its sources has one more file in their folders, which its rebuild skips.
constexpr std::string_view kCarriedNote = "SOURCE";
/// Pictures for a list of models, which no simulator reads.
constexpr std::string_view kThumbnails = "thumbnails/";

Diagnostic not_usable(const FuelNeed& need, std::string message, std::string why) {
  return Diagnostic{.code = "R2W0536",
                    .message = std::move(message),
                    .span = need.span,
                    .why = {std::move(why)},
                    .fix = {"correct its address, or put a model of that name into a package"}};
}

bool is_version(const std::string& text) {
  return !text.empty() && text.size() < 10 &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

bool has_model(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().filename() == "model.config" || it->path().extension() == ".sdf") return true;
  }
  return false;
}

class FuelModels {
 public:
  FuelModels(const SourcesRequest& request, const ChannelRoots& roots, const ExtractLimits& limits,
             const std::vector<LocalPackage>& packages, WorkspaceSources& sources,
             const Cancellation& cancellation, const ProgressSink& progress)
      : request_(request),
        roots_(roots),
        limits_(limits),
        packages_(packages),
        sources_(sources),
        cancellation_(cancellation),
        progress_(progress) {}

  Outcome<Done> add(std::vector<FuelNeed> needs) {
    if (needs.empty()) return Done{};
    auto locked = locked_sources(request_);
    if (!locked) return std::move(locked).errors();
    locked_ = *std::move(locked);
    if (auto marked = mark_cache(roots_.cache); !marked) return marked;
    begin_step(progress_, "fetch");
    while (!needs.empty()) {
      std::vector<FuelNeed> more;
      Diagnostics errors;
      for (const FuelNeed& need : needs) {
        if (cancellation_.requested()) return interrupted();
        if (!known_.insert(need.folder).second) continue;
        if (known_.size() > kMostModels)
          return not_usable(need, "the workspace needs too many models of Gazebo Fuel",
                            "there are more than " + std::to_string(kMostModels));
        if (auto added = add_one(need, more); !added) append(errors, added.errors(), need.span);
      }
      if (!errors.empty()) return errors;
      needs = std::move(more);
    }
    return Done{};
  }

 private:
  Outcome<Done> add_one(const FuelNeed& need, std::vector<FuelNeed>& more) {
    const auto known =
        std::find_if(locked_.begin(), locked_.end(),
                     [&need](const LockedSource& one) { return one.model == need.title; });
    const bool is_locked = known != locked_.end();
    if (!is_locked && request_.must_be_locked)
      return Diagnostic{.code = "R2W0311",
                        .message = "the model `" + need.title + "` is not in the lock",
                        .span = need.span,
                        .fix = {"ros2wasm lock"}};
    LockedSource source;
    if (is_locked) {
      source = *known;
    } else {
      auto fetched = fetch(need);
      if (!fetched) return std::move(fetched).errors();
      source = *std::move(fetched);
    }
    auto tree = unpacked(need, source, is_locked);
    if (!tree) return std::move(tree).errors();
    if (!has_model(tree->folder))
      return not_usable(need, "the archive of `" + need.title + "` has no model",
                        "neither `model.config` nor a file `*.sdf` is at its top");
    tree->locked = std::move(source);
    for (FuelNeed& one : fuel_needs_of_model(tree->folder, need, packages_))
      more.push_back(std::move(one));
    if (tree->is_new || !is_locked)
      sources_.remarks.push_back("fetched the model " + need.title + " of Gazebo Fuel");
    sources_.trees.push_back(*std::move(tree));
    return Done{};
  }

  /// The newest version is locked by its number, so that the address gives the same file later.
  Outcome<LockedSource> fetch(const FuelNeed& need) const {
    const auto beside = TemporaryDirectory::make(roots_.cache / "sources" / "unfinished", "fuel.");
    if (!beside) return beside.errors();
    const fs::path file = beside->path() / "archive";
    auto version = bring_new({.what = "the model `" + need.title + "` of Gazebo Fuel",
                              .url = need.archive,
                              .place = file,
                              .limit_bytes = kMostOfArchive,
                              .asked_header = kVersionHeader},
                             roots_.network, cancellation_);
    if (!version) {
      Diagnostics errors = std::move(version).errors();
      for (Diagnostic& one : errors)
        if (one.code == "R2W0228")
          one = not_usable(need, "Gazebo Fuel does not have the model `" + need.title + "`",
                           one.why.front() + "; " + one.why.back());
      return errors;
    }
    const auto hashes = hash_file(file);
    if (!hashes) return hashes.errors();
    LockedSource source{
        .git = {},
        .revision = {},
        .commit = {},
        .tree = {},
        .archive = is_version(*version) ? fuel_archive_of(need.title, *version) : need.archive,
        .sha256 = hashes->sha256,
        .size = hashes->size,
        .model = need.title};
    const fs::path place = source_archive_place(roots_.cache, source.sha256);
    if (auto made = make_directories(place.parent_path()); !made) return std::move(made).errors();
    std::error_code error;
    fs::rename(file, place, error);
    if (error) return cannot_write(place, error.value());
    return source;
  }

  Outcome<SourceTree> unpacked(const FuelNeed& need, const LockedSource& source, bool is_locked) {
    std::vector<LockedSource> locked = locked_;
    if (!is_locked) locked.push_back(source);
    auto trees = bring_source_trees({.entries = {{.kind = SourceKind::kArchive,
                                                  .place = source.archive,
                                                  .revision = {},
                                                  .sha256 = source.sha256,
                                                  .name = need.name,
                                                  .repos = {},
                                                  .packages = {},
                                                  .package_places = {},
                                                  .span = need.span}},
                                     .locked = std::move(locked),
                                     .must_be_locked = true,
                                     .takes_carried = request_.takes_carried},
                                    roots_, limits_, cancellation_, progress_);
    if (!trees) {
      Diagnostics errors = std::move(trees).errors();
      for (Diagnostic& one : errors)
        if (one.code == "R2W0220" && is_locked)
          one.fix = {"ros2wasm lock --update '" + need.name + "'"};
      return errors;
    }
    return std::move(trees->front());
  }

  const SourcesRequest& request_;
  const ChannelRoots& roots_;
  const ExtractLimits& limits_;
  const std::vector<LocalPackage>& packages_;
  WorkspaceSources& sources_;
  const Cancellation& cancellation_;
  const ProgressSink& progress_;
  std::vector<LockedSource> locked_;
  std::set<std::string> known_;  ///< folders in the site
};

}  // namespace

Outcome<Done> add_fuel_models(const Manifest& manifest, const SourcesRequest& request,
                              const ChannelRoots& roots, const ExtractLimits& limits,
                              const std::vector<LocalPackage>& packages, WorkspaceSources& sources,
                              Diagnostics& warnings, const Cancellation& cancellation,
                              const ProgressSink& progress) {
  std::vector<FuelNeed> needs = fuel_needs(packages, request.folder, request.shown_folder);
  if (!manifest.fetches_fuel) {
    for (const FuelNeed& need : needs) warnings.push_back(missing_fuel_model(need));
    return Done{};
  }
  return FuelModels(request, roots, limits, packages, sources, cancellation, progress)
      .add(std::move(needs));
}

Outcome<Done> collect_fuel_models(const std::vector<SourceTree>& trees, SharedFiles& into) {
  for (const SourceTree& tree : trees) {
    const std::string folder = fuel_folder_of(tree.locked.model);
    if (folder.empty()) continue;
    const auto files = list_tree(tree.folder);
    if (!files) return files.errors();
    for (const TreeEntry& entry : *files) {
      // Links would be read through, and a backslash in an address is a slash.
      if (entry.kind != FileKind::kFile || entry.path == kCarriedNote ||
          entry.path.starts_with(kThumbnails) || entry.path.find('\\') != std::string::npos)
        continue;
      auto bytes = read_file(tree.folder / entry.path, kMostOfData);
      if (!bytes) return std::move(bytes).errors();
      into.emplace("share/ros2wasm_sim/fuel/" + folder + "/" + entry.path, *std::move(bytes));
    }
  }
  return Done{};
}

}  // namespace ros2wasm
