// See source_packages.hpp.
#include "bundler/workspace/source_packages.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "bundler/io/files.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/base/suggestion.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLfsBeginning = "version https://git-lfs.github.com/spec/";
constexpr std::uint64_t kMostOfPointer = 1024;  // bytes
constexpr std::size_t kShownDigits = 10;

/// How messages name the folder of a source.
fs::path shown_folder(const SourceTree& tree, const fs::path& shown_base) {
  return tree.can_change ? (shown_base / tree.entry.place).lexically_normal()
                         : fs::path(tree.entry.name);
}

/// As SPDX writes the place of a download.
std::string origin_of(const SourceTree& tree) {
  const LockedSource& is = tree.locked;
  if (tree.can_change) return {};
  if (is.git.empty()) return is.archive;
  if (is.git.find("://") != std::string::npos || !is_source_address(is.git))
    return "git+" + is.git + "@" + is.commit;
  std::string address = is.git;  // user@host:path
  address[address.find(':')] = '/';
  return "git+ssh://" + address + "@" + is.commit;
}

/// "navigation2 1.3.7, commit 0123456789"
std::string title_of(const SourceTree& tree) {
  std::string title = tree.entry.name;
  if (tree.locked.git.empty()) return title;
  if (!tree.entry.revision.empty() && tree.entry.revision != tree.locked.commit)
    title += " " + tree.entry.revision;
  return title + ", commit " + tree.locked.commit.substr(0, kShownDigits);
}

/// A package that a source has.
struct Offer {
  std::vector<fs::path> folders;  ///< absolute
  std::vector<std::string> needs;
};

std::vector<std::string> needs_of(const PackageXml& xml) {
  return xml.names_of({DependencyKind::kBuild, DependencyKind::kBuildExport,
                       DependencyKind::kBuildTool, DependencyKind::kBuildToolExport,
                       DependencyKind::kExec});
}

class Choice {
 public:
  Choice(const std::vector<SourceTree>& trees, const std::vector<LocalPackage>& workspace,
         const fs::path& shown_base, const ConditionVariables& variables)
      : trees_(trees), shown_base_(shown_base), variables_(variables), offers_(trees.size()) {
    for (const LocalPackage& one : workspace)
      workspace_.emplace(one.xml.name.value, needs_of(one.xml));
  }

  Outcome<SourcePackages> choose() {
    for (std::size_t i = 0; i < trees_.size(); ++i) read_offers(i);
    for (std::size_t i = 0; i < trees_.size(); ++i) ask_for_named(i);
    check_names();
    if (!errors_.empty()) return std::move(errors_);
    follow_needs();
    SourcePackages result;
    for (std::size_t i = 0; i < trees_.size(); ++i) add_packages(i, result);
    if (!errors_.empty()) return std::move(errors_);
    for (const std::string& name : replaced_)
      result.remarks.push_back(name + " is taken from the workspace, not from a source");
    return result;
  }

 private:
  void read_offers(std::size_t i) {
    const fs::path shown = shown_folder(trees_[i], shown_base_);
    for (const fs::path& folder : find_package_folders(trees_[i].folder)) {
      // One that nobody asks for may be broken; add_packages() reports those that are taken.
      const auto xml = package_description(folder, trees_[i].folder, shown, variables_);
      if (xml) {
        Offer& offer = offers_[i][xml->name.value];
        if (offer.folders.empty()) offer.needs = needs_of(*xml);
        offer.folders.push_back(folder);  // more than one is R2W0511, when they are taken
      } else {
        broken_[i].push_back(folder);
      }
    }
  }

  void ask_for_named(std::size_t i) {
    const NamedSource& entry = trees_[i].entry;
    if (!entry.packages.empty()) {
      for (const std::string& name : entry.packages) {
        if (offers_[i].contains(name) || workspace_.contains(name)) take(i, name);
      }
      return;
    }
    if (offers_[i].empty() && broken_[i].empty() && !trees_[i].is_carried)
      errors_.push_back(Diagnostic{.code = "R2W0255",
                                   .message = "the source `" + entry.name + "` has no ROS package",
                                   .span = entry.span,
                                   .label = "no package.xml in it"});
    for (const auto& [name, offer] : offers_[i]) take(i, name);
  }

  /// The entries of a .repos file have one list together, so a name must be in one of them.
  void check_names() {
    for (const SourceTree& tree : trees_) {
      const NamedSource& entry = tree.entry;
      for (std::size_t k = 0; k < entry.packages.size(); ++k) {
        const std::string& name = entry.packages[k];
        if (workspace_.contains(name)) continue;
        std::vector<std::string> there;
        for (std::size_t i = 0; i < trees_.size(); ++i) {
          const bool is_same_list = !entry.repos.empty() && trees_[i].entry.repos == entry.repos;
          if (&trees_[i] != &tree && !is_same_list) continue;
          for (const auto& [offered, offer] : offers_[i]) there.push_back(offered);
        }
        if (std::find(there.begin(), there.end(), name) != there.end()) continue;
        Diagnostic missing{
            .code = "R2W0255",
            .message = "the source `" + entry.name + "` has no package `" + name + "`",
            .span = {}};
        // A package of a distribution is named by no line of the manifest.
        if (entry.package_places[k].line > 0) missing.span = entry.package_places[k];
        if (!there.empty()) missing.why.push_back("it has: " + name_list(there, 12));
        if (const auto near = nearest(name, there)) missing.fix.push_back("write `" + *near + "`");
        const bool known = std::any_of(errors_.begin(), errors_.end(), [&](const Diagnostic& one) {
          return missing.span && one.span == missing.span;
        });
        if (!known) errors_.push_back(std::move(missing));
      }
    }
  }

  void take(std::size_t i, const std::string& name) {
    const auto own = workspace_.find(name);
    if (own != workspace_.end()) {
      if (replaced_.insert(name).second) open_.emplace_back(i, own->second);
    } else if (taken_.emplace(i, name).second) {
      open_.emplace_back(i, offers_[i].at(name).needs);
    }
  }

  void follow_needs() {
    while (!open_.empty()) {
      const auto [i, needs] = std::move(open_.back());
      open_.pop_back();
      for (const std::string& need : needs) {
        const bool is_taken = std::any_of(taken_.begin(), taken_.end(),
                                          [&](const auto& one) { return one.second == need; });
        if (is_taken) continue;
        if (const auto from = who_offers(need, i)) take(*from, need);
      }
    }
  }

  /// The source itself before the others, and these in the order of the manifest.
  [[nodiscard]] std::optional<std::size_t> who_offers(const std::string& name,
                                                      std::size_t first) const {
    if (offers_[first].contains(name)) return first;
    for (std::size_t i = 0; i < offers_.size(); ++i)
      if (offers_[i].contains(name)) return i;
    return std::nullopt;
  }

  void add_packages(std::size_t i, SourcePackages& result) {
    const SourceTree& tree = trees_[i];
    const fs::path shown = shown_folder(tree, shown_base_);
    std::vector<fs::path> folders;
    if (tree.entry.packages.empty()) folders = broken_[i];
    for (const auto& [owner, name] : taken_)
      if (owner == i)
        for (const fs::path& folder : offers_[i].at(name).folders) folders.push_back(folder);
    std::sort(folders.begin(), folders.end());
    auto found = read_packages(folders, tree.folder, shown, variables_);
    if (!found) return append(errors_, found.errors());
    std::vector<std::string> names;
    for (LocalPackage& package : *found) {
      if (auto pointers = lfs_pointers(package)) errors_.push_back(*std::move(pointers));
      package.origin = origin_of(tree);
      names.push_back(package.xml.name.value);
      result.packages.push_back(std::move(package));
    }
    if (names.empty()) return;
    std::sort(names.begin(), names.end());
    result.remarks.push_back("from " + title_of(tree) + ": " + name_list(names, 12));
    for (const std::string& link : tree.left_out)
      result.remarks.push_back("skipped the link " + link + " of " + tree.entry.name +
                               ", which leads out of it");
  }

  static std::optional<Diagnostic> lfs_pointers(const LocalPackage& package) {
    const auto entries = list_tree(package.directory);
    if (!entries) return std::nullopt;  // discovery has read it
    std::vector<std::string> pointers;
    for (const TreeEntry& entry : *entries) {
      if (entry.kind != FileKind::kFile || entry.size > kMostOfPointer) continue;
      const auto text = read_file(package.directory / entry.path, kMostOfPointer);
      if (text && text->starts_with(kLfsBeginning)) pointers.push_back(entry.path);
    }
    if (pointers.empty()) return std::nullopt;
    return Diagnostic{
        .code = "R2W0254",
        .message = "the package `" + package.xml.name.value +
                   "` has files of Git LFS, which are not there",
        .why = {"Git LFS has: " + name_list(pointers)},
        .fix = {"clone the repository with `git lfs` and name its folder with `folder:`"}};
  }

  const std::vector<SourceTree>& trees_;
  const fs::path& shown_base_;
  const ConditionVariables& variables_;
  std::map<std::string, std::vector<std::string>> workspace_;  ///< what each package needs
  std::vector<std::map<std::string, Offer>> offers_;           ///< by name, for each source
  std::map<std::size_t, std::vector<fs::path>> broken_;
  std::set<std::pair<std::size_t, std::string>> taken_;
  /// Needs that are not followed yet, and the source that is asked first.
  std::vector<std::pair<std::size_t, std::vector<std::string>>> open_;
  std::set<std::string> replaced_;
  Diagnostics errors_;
};

}  // namespace

Outcome<SourcePackages> choose_source_packages(const std::vector<SourceTree>& trees,
                                               const std::vector<LocalPackage>& workspace,
                                               const fs::path& shown_base,
                                               const ConditionVariables& variables) {
  return Choice(trees, workspace, shown_base, variables).choose();
}

}  // namespace ros2wasm
