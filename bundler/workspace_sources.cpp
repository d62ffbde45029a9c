// See workspace_sources.hpp.
#include "bundler/workspace_sources.hpp"

#include <algorithm>
#include <tuple>

#include "bundler/io/files.hpp"
#include "bundler/store/cache_care.hpp"
#include "bundler/workspace/source_packages.hpp"

namespace ros2wasm {
namespace {

std::string name_of(const LockedSource& source) {
  if (!source.package.empty()) return source.package;
  if (!source.model.empty()) {
    const std::size_t name = source.model.find('/') + 1;
    return source.model.substr(name, source.model.find('/', name) - name);
  }
  return source_name(source.git.empty() ? source.archive : source.git);
}

}  // namespace

Outcome<std::vector<LockedSource>> locked_sources(const SourcesRequest& request) {
  const std::filesystem::path file = request.folder / kLockFileName;
  if (is_absent(file) || request.update.everything) return std::vector<LockedSource>();
  auto lock = read_lock_file(file);
  if (!lock) return std::move(lock).errors();
  const std::vector<std::string>& names = request.update.names;
  std::erase_if(lock->sources, [&names](const LockedSource& one) {
    return std::find(names.begin(), names.end(), name_of(one)) != names.end();
  });
  return std::move(lock->sources);
}

Outcome<WorkspaceSources> add_source_packages(
    const Manifest& manifest, const SourcesRequest& request, const ChannelRoots& roots,
    const ExtractLimits& limits, std::vector<LocalPackage>& packages,
    const Cancellation& cancellation, const ProgressSink& progress) {
  WorkspaceSources sources;
  if (manifest.sources.empty()) return sources;
  auto locked = locked_sources(request);
  if (!locked) return std::move(locked).errors();
  if (auto marked = mark_cache(roots.cache); !marked) return std::move(marked).errors();
  begin_step(progress, "fetch");
  auto trees = bring_source_trees({.entries = manifest.sources,
                                   .locked = *std::move(locked),
                                   .must_be_locked = request.must_be_locked,
                                   .takes_carried = request.takes_carried},
                                  roots, limits, cancellation, progress);
  if (!trees) return std::move(trees).errors();
  auto chosen = choose_source_packages(*trees, packages, request.shown_folder,
                                       ros_condition_variables(manifest.distro));
  if (!chosen) return std::move(chosen).errors();
  for (LocalPackage& package : chosen->packages) {
    if (package.origin.empty()) sources.watched.push_back(package.directory);
    packages.push_back(std::move(package));
  }
  for (const NamedSource& entry : manifest.sources) {
    const bool is_file = entry.kind == SourceKind::kRepos ||
                         (entry.kind == SourceKind::kArchive && !is_web_place(entry.place));
    if (is_file) sources.watched.push_back(request.folder / entry.place);
  }
  order_plain_packages(packages);
  sources.trees = std::move(*trees);
  sources.remarks = std::move(chosen->remarks);
  return sources;
}

std::vector<LockedSource> sources_to_lock(const std::vector<SourceTree>& trees,
                                          const std::vector<LocalPackage>& packages) {
  std::vector<LockedSource> sources;
  for (const SourceTree& tree : trees) {
    if (tree.can_change) continue;
    LockedSource& source = sources.emplace_back(tree.locked);
    source.packages.clear();
    for (const LocalPackage& one : packages) {
      const bool is_of_it =
          tree.locked.package.empty() || tree.locked.package == one.xml.name.value;
      if (one.base == tree.folder && is_of_it)
        source.packages.push_back(one.xml.name.value + " " + one.xml.version.value);
    }
    std::sort(source.packages.begin(), source.packages.end());
  }
  std::sort(sources.begin(), sources.end(), [](const LockedSource& a, const LockedSource& b) {
    return std::tie(a.git, a.archive, a.revision, a.package) <
           std::tie(b.git, b.archive, b.revision, b.package);
  });
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  return sources;
}

LockUpdate without_sources(LockUpdate update, const std::vector<SourceTree>& trees) {
  std::erase_if(update.names, [&trees](const std::string& name) {
    return std::any_of(trees.begin(), trees.end(), [&name](const SourceTree& tree) {
      return !tree.can_change && tree.entry.name == name;
    });
  });
  return update;
}

}  // namespace ros2wasm
