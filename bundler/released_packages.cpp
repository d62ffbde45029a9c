// See released_packages.hpp.
#include "bundler/released_packages.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "bundler/channel/transport.hpp"
#include "bundler/io/files.hpp"
#include "bundler/launch/unsupported_programs.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/source_packages.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/names.hpp"
#include "workspace_schema/schema/distribution_file.hpp"

namespace ros2wasm {
namespace {

using Released = std::map<std::string, ReleasedPackage>;

class ReleasedPackages {
 public:
  ReleasedPackages(const Manifest& manifest, const SourcesRequest& request,
                   const ChannelRoots& roots, const ExtractLimits& limits,
                   const std::vector<std::string>& known_names, std::vector<LocalPackage>& packages,
                   WorkspaceSources& sources, const Cancellation& cancellation,
                   const ProgressSink& progress)
      : manifest_(manifest),
        request_(request),
        roots_(roots),
        limits_(limits),
        known_names_(known_names),
        packages_(packages),
        sources_(sources),
        cancellation_(cancellation),
        progress_(progress) {
    for (const NodeEntry& node : manifest.nodes) launched_.insert(node.package.value);
    for (const ProgramEntry& program : manifest.programs) launched_.insert(program.package.value);
    for (const auto& dependency : manifest.dependencies)
      if (!package_name_fault(dependency.value)) launched_.insert(dependency.value);
    for (const LocalPackage& package : packages) add_launched(package);
    for (const NamedSource& one : manifest.sources) {
      if (one.kind == SourceKind::kDistribution)
        launched_.insert(one.packages.begin(), one.packages.end());
    }
  }

  Outcome<Done> add() {
    auto locked = locked_sources(request_);
    if (!locked) return std::move(locked).errors();
    locked_ = *std::move(locked);
    for (;;) {
      auto entries = missing_sources();
      if (!entries) return std::move(entries).errors();
      if (entries->empty()) break;
      if (auto added = bring(*std::move(entries)); !added) return added;
    }
    order_plain_packages(packages_);
    return Done{};
  }

 private:
  void add_launched(const LocalPackage& package) {
    for (const auto& name : package.launch_packages) launched_.insert(name.value);
  }

  /// The names that must come from somewhere. Names that are only in a package.xml, for running,
  /// are not among them: most of these packages are never started.
  [[nodiscard]] std::set<std::string> wanted() const {
    std::set<std::string> names = launched_;
    for (const ExternalDependency& one : external_dependencies(packages_, {}, manifest_.distro)) {
      if (one.needed_to_build && !one.can_be_missing) names.insert(one.name);
    }
    for (const LocalPackage& package : packages_)
      for (const auto& module : package.python_modules) names.insert(module.value);
    return names;
  }

  [[nodiscard]] bool is_here(const std::string& name) const {
    const auto has = [this](const std::string& one) {
      return std::binary_search(known_names_.begin(), known_names_.end(), one);
    };
    return has(conda_name(name, manifest_.distro)) || has(name) ||
           std::any_of(packages_.begin(), packages_.end(),
                       [&name](const LocalPackage& one) { return one.xml.name.value == name; });
  }

  Outcome<std::vector<NamedSource>> missing_sources() {
    std::vector<NamedSource> entries;
    for (const std::string& name : wanted()) {
      // Each is asked for once: a package that its tag does not have stays missing.
      if (is_here(name) || has_stand_in(name, [](const std::string&) { return false; }) ||
          !asked_.insert(name).second)
        continue;
      auto entry = source_of(name);
      if (!entry) return std::move(entry).errors();
      if (*entry) entries.push_back(**std::move(entry));
    }
    return entries;
  }

  /// As the lock has it, else as a distribution file says.
  Outcome<std::optional<NamedSource>> source_of(const std::string& name) {
    const auto in_lock =
        std::find_if(locked_.begin(), locked_.end(),
                     [&name](const LockedSource& one) { return one.package == name; });
    NamedSource entry{.kind = SourceKind::kGit,
                      .place = {},
                      .revision = {},
                      .sha256 = {},
                      .name = name,
                      .repos = {},
                      .packages = {name},
                      .package_places = {SourceSpan{.file = {}, .line_text = {}}},
                      .span = {}};
    if (in_lock != locked_.end()) {
      entry.place = in_lock->git;
      entry.revision = in_lock->revision;
      return std::optional<NamedSource>(std::move(entry));
    }
    if (request_.must_be_locked) return std::optional<NamedSource>();
    const auto released = distribution();
    if (!released) return released.errors();
    const auto found = (*released)->find(name);
    if (found == (*released)->end()) return std::optional<NamedSource>();
    entry.place = found->second.url;
    entry.revision = found->second.tag;
    return std::optional<NamedSource>(std::move(entry));
  }

  /// Read when it is needed first; of several files, the first one that has a package counts.
  Outcome<const Released*> distribution() {
    if (distribution_) return &*distribution_;
    Released all;
    for (const NamedSource& one : manifest_.sources) {
      if (one.kind != SourceKind::kDistribution) continue;
      auto read = read_distribution(one.place, roots_, cancellation_);
      // The lock was made with the list: it has what the list was needed for.
      if (!read && read.errors().front().code == "R2W0253" && roots_.network.offline &&
          !is_absent(request_.folder / kLockFileName))
        continue;
      if (!read) {
        Diagnostics errors;
        append(errors, read.errors(), one.span);
        return errors;
      }
      all.merge(*read);
    }
    distribution_ = std::move(all);
    return &*distribution_;
  }

  Outcome<Done> bring(std::vector<NamedSource> entries) {
    auto trees = bring_source_trees({.entries = std::move(entries),
                                     .locked = locked_,
                                     .must_be_locked = request_.must_be_locked,
                                     .takes_carried = request_.takes_carried},
                                    roots_, limits_, cancellation_, progress_);
    if (!trees) return std::move(trees).errors();
    auto chosen = choose_source_packages(*trees, packages_, request_.shown_folder,
                                         ros_condition_variables(manifest_.distro));
    if (!chosen) return std::move(chosen).errors();
    for (LocalPackage& package : chosen->packages) {
      if (launched_.contains(package.xml.name.value)) add_launched(package);
      packages_.push_back(std::move(package));
    }
    for (SourceTree& tree : *trees) {
      tree.locked.package = tree.entry.name;
      sources_.trees.push_back(std::move(tree));
    }
    sources_.remarks.insert(sources_.remarks.end(), chosen->remarks.begin(), chosen->remarks.end());
    return Done{};
  }

  const Manifest& manifest_;
  const SourcesRequest& request_;
  const ChannelRoots& roots_;
  const ExtractLimits& limits_;
  const std::vector<std::string>& known_names_;
  std::vector<LocalPackage>& packages_;
  WorkspaceSources& sources_;
  const Cancellation& cancellation_;
  const ProgressSink& progress_;
  std::vector<LockedSource> locked_;
  std::optional<Released> distribution_;
  std::set<std::string> launched_;  ///< packages that something starts or looks up
  std::set<std::string> asked_;
};

}  // namespace

Outcome<Released> read_distribution(const std::string& place, const ChannelRoots& roots,
                                    const Cancellation& cancellation) {
  std::filesystem::path file = roots.working_directory / place;
  if (is_web_place(place)) {
    auto local = bring(place, roots, cancellation);
    if (!local) return std::move(local).errors();
    if (!*local)
      return Diagnostic{
          .code = "R2W0253",
          .kind = FailureKind::kEnvironment,
          .message = "`" + place + "` is not on this machine",
          .why = {roots.network.offline ? "with --offline nothing comes over the network"
                                        : "the server has no such file"}};
    file = **std::move(local);
  }
  const auto text = read_file(file, kMostOfText);
  if (!text) return text.errors();
  auto released = read_distribution_file(*text, place);
  if (!released || !is_web_place(place)) return released;
  // A list from the web must not name what only this user can read.
  std::erase_if(*released, [](const auto& one) { return reach_of(one.second.url) > Reach::kWeb; });
  return released;
}

Outcome<Done> add_released_packages(const Manifest& manifest, const SourcesRequest& request,
                                    const ChannelRoots& roots, const ExtractLimits& limits,
                                    const std::vector<std::string>& known_names,
                                    std::vector<LocalPackage>& packages, WorkspaceSources& sources,
                                    const Cancellation& cancellation,
                                    const ProgressSink& progress) {
  const bool has_distribution =
      std::any_of(manifest.sources.begin(), manifest.sources.end(),
                  [](const NamedSource& one) { return one.kind == SourceKind::kDistribution; });
  if (!has_distribution) return Done{};
  return ReleasedPackages(manifest, request, roots, limits, known_names, packages, sources,
                          cancellation, progress)
      .add();
}

}  // namespace ros2wasm
