// See source_trees.hpp. In the cache, `sources/<two letters>/<key>` has the files below `tree`, so
// that the stamp is not one of them, and a seal beside it.
#include "bundler/store/source_trees.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/link_rules.hpp"
#include "bundler/archive/unpacker.hpp"
#include "bundler/channel/verified_files.hpp"
#include "bundler/io/cached_folder.hpp"
#include "bundler/io/file_lock.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/git.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/store/tree_seal.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"
#include "workspace_schema/schema/repos_file.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTree = "tree";
constexpr std::size_t kMostSubmodules = 100;
/// Bytes, so that git can say what is wrong.
constexpr std::uint64_t kLeastPack = 1U << 16U;
constexpr int kDeepestSubmodule = 8;

fs::path seal_place(const fs::path& place) {
  return place.string() + ".seal";
}

/// Nothing of the network is needed to read it.
bool is_here(const std::string& address) {
  return reach_of(address) == Reach::kMachine;
}

/// `../parts.git` beside the address that names it.
std::string submodule_address(std::string base, std::string_view url) {
  if (!url.starts_with("./") && !url.starts_with("../")) return std::string(url);
  while (base.ends_with('/')) base.pop_back();
  while (url.starts_with("./") || url.starts_with("../")) {
    const bool up = url.starts_with("../");
    url.remove_prefix(up ? 3 : 2);
    const std::size_t end = base.find_last_of("/:");
    if (!up || end == std::string::npos) continue;
    // `git@host:arms.git` and `../parts.git` are `git@host:parts.git`.
    if (base[end] == ':') return base.substr(0, end + 1) + std::string(url);
    base.resize(end);
  }
  return base + "/" + std::string(url);
}

Diagnostic not_taken(const std::string& source, std::string why) {
  return Diagnostic{.code = "R2W0254",
                    .message = "the source `" + source + "` is not taken",
                    .why = {std::move(why), "nothing of it was stored"}};
}

Diagnostic not_here(const std::string& address) {
  return Diagnostic{.code = "R2W0253",
                    .kind = FailureKind::kEnvironment,
                    .message = "`" + address + "` is not on this machine",
                    .why = {"with --offline nothing comes over the network"},
                    .fix = {"ros2wasm cache fetch ros2wasm.lock"}};
}

/// Brings one commit with its submodules into a folder.
class GitTree {
 public:
  GitTree(const std::string& source, fs::path work, const ExtractLimits& limits, bool offline,
          const Cancellation& cancellation)
      : source_(source),
        work_(std::move(work)),
        limits_(limits),
        offline_(offline),
        cancellation_(cancellation) {}

  struct Names {
    std::string commit;
    std::string tree;
  };

  /// The names that the cache would have it by, which `is_known` is asked for before any file is
  /// written.
  Outcome<Names> bring(const std::string& address, const std::string& revision,
                       const fs::path& folder,
                       const std::function<bool(const Names& names)>& is_known) {
    const auto repository = open(address);
    if (!repository) return repository.errors();
    auto commit = repository->fetch(revision);
    if (!commit) return std::move(commit).errors();
    auto tree = repository->tree_of(*commit);
    if (!tree) return std::move(tree).errors();
    Names names{.commit = std::move(*commit), .tree = std::move(*tree)};
    if (is_known(names)) return names;
    if (auto done = write(*repository, address, names.commit, folder, 0); !done)
      return std::move(done).errors();
    if (auto done = drop_links_out(folder); !done) return std::move(done).errors();
    return names;
  }

  std::vector<std::string> take_left_out() { return std::move(left_out_); }

 private:
  Outcome<GitRepository> open(const std::string& address) {
    if (offline_ && !is_here(address)) return not_here(address);
    const std::uint64_t left = limits_.total_bytes - std::min(bytes_, limits_.total_bytes);
    return GitRepository::make(address, work_ / "git" / std::to_string(repositories_++),
                               std::max(left, kLeastPack), cancellation_);
  }

  Outcome<Done> write(const GitRepository& repository, const std::string& address,
                      const std::string& commit, const fs::path& folder, int depth) {
    const auto entries = repository.entries(commit);
    if (!entries) return entries.errors();
    if (auto judged = judge(*entries); !judged) return judged;
    if (auto made = make_directories(folder); !made) return made;
    if (auto done = repository.check_out(commit, folder); !done) return done;
    if (std::none_of(entries->begin(), entries->end(),
                     [](const GitEntry& one) { return one.kind == GitObjectKind::kCommit; }))
      return Done{};
    const auto modules = repository.submodules(commit);
    if (!modules) return modules.errors();
    for (const GitEntry& entry : *entries) {
      if (entry.kind != GitObjectKind::kCommit) continue;
      const auto module =
          std::find_if(modules->begin(), modules->end(),
                       [&](const GitSubmodule& one) { return one.path == entry.path; });
      // Also git leaves the folder of one that .gitmodules does not name empty.
      if (module == modules->end()) continue;
      if (auto done = add_submodule(address, *module, entry, folder / entry.path, depth + 1); !done)
        return done;
    }
    return Done{};
  }

  Outcome<Done> add_submodule(const std::string& parent, const GitSubmodule& module,
                              const GitEntry& entry, const fs::path& folder, int depth) {
    const std::string address = submodule_address(parent, module.url);
    std::string fault = git_address_fault(address);
    // A repository of strangers must not name what only this user can read.
    if (fault.empty() && reach_of(address) > reach_of(parent))
      fault = is_here(address) ? "it is a path on this machine"
                               : "it needs your ssh keys, and the repository itself does not";
    if (!fault.empty())
      return not_taken(
          source_, "its submodule `" + module.path + "` comes from `" + address + "`: " + fault);
    if (depth > kDeepestSubmodule || ++submodules_ > kMostSubmodules)
      return not_taken(source_, "it has more than " + std::to_string(kMostSubmodules) +
                                    " submodules, or submodules of submodules " +
                                    std::to_string(kDeepestSubmodule) + " deep");
    const auto repository = open(address);
    if (!repository) return repository.errors();
    const auto commit = repository->fetch(entry.object);
    if (!commit) return commit.errors();
    return write(*repository, address, *commit, folder, depth);
  }

  /// By names and sizes, before anything is written.
  Outcome<Done> judge(const std::vector<GitEntry>& entries) {
    for (const GitEntry& entry : entries) {
      bytes_ += entry.size;
      if (safe_member_path(entry.path) != entry.path)
        return not_taken(source_, "a file of it has a name that cannot be stored");
    }
    members_ += entries.size();
    if (bytes_ > limits_.total_bytes || members_ > limits_.members)
      return not_taken(source_, "it has " + std::to_string(members_) + " files with " +
                                    std::to_string(bytes_) + " bytes; the limits are " +
                                    std::to_string(limits_.members) + " and " +
                                    std::to_string(limits_.total_bytes));
    return Done{};
  }

  /// Honest repositories have such links too, to what only their authors have.
  Outcome<Done> drop_links_out(const fs::path& folder) {
    const auto entries = list_tree(folder);
    if (!entries) return entries.errors();
    for (const TreeEntry& entry : *entries) {
      if (entry.kind == FileKind::kLink && (!link_stays_inside(entry.path, entry.link_target) ||
                                            !link_ends_inside(folder, entry.path))) {
        if (auto removed = remove_tree(folder / entry.path); !removed) return removed;
        left_out_.push_back(entry.path);
      }
    }
    return Done{};
  }

  const std::string& source_;
  fs::path work_;
  const ExtractLimits& limits_;
  bool offline_;
  const Cancellation& cancellation_;
  std::size_t repositories_ = 0;
  std::size_t submodules_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t members_ = 0;
  std::vector<std::string> left_out_;
};

class Bringer {
 public:
  Bringer(const SourceTreesRequest& request, const ChannelRoots& roots, const ExtractLimits& limits,
          const Cancellation& cancellation, const ProgressSink& progress)
      : request_(request),
        roots_(roots),
        limits_(limits),
        cancellation_(cancellation),
        progress_(progress) {}

  Outcome<std::vector<SourceTree>> bring() {
    std::vector<SourceTree> trees;
    Diagnostics errors;
    for (const NamedSource& entry : request_.entries) {
      if (cancellation_.requested()) return interrupted();
      auto all = with_repos(entry);
      if (!all) append(errors, all.errors());
      if (!all) continue;
      for (NamedSource& one : *all) {
        const SourceSpan span = one.span;
        auto tree = bring_one(std::move(one));
        if (tree) {
          trees.push_back(std::move(*tree));
          continue;
        }
        for (Diagnostic fault : tree.errors()) {
          if (!fault.span && span.line > 0) fault.span = span;
          errors.push_back(std::move(fault));
        }
      }
    }
    if (cancellation_.requested()) return interrupted();
    if (!errors.empty()) return errors;
    return trees;
  }

 private:
  /// Those of a .repos file in its place.
  Outcome<std::vector<NamedSource>> with_repos(const NamedSource& entry) const {
    // Packages of a distribution are asked for one by one, as git repositories.
    if (entry.kind == SourceKind::kDistribution) return std::vector<NamedSource>();
    if (entry.kind != SourceKind::kRepos) return std::vector<NamedSource>{entry};
    const auto text = read_file(roots_.working_directory / entry.place, kMostOfText);
    if (!text) return text.errors();
    auto entries = read_repos_file(*text, entry.place);
    if (!entries) return entries;
    for (NamedSource& one : *entries) {
      one.packages = entry.packages;
      one.package_places = entry.package_places;
    }
    return entries;
  }

  Outcome<SourceTree> bring_one(NamedSource entry) {
    if (entry.kind == SourceKind::kFolder) return folder_of(std::move(entry));
    if (progress_)
      progress_({.step = "fetch", .item = entry.name, .done = 0, .total = 0, .unit = {}});
    return entry.kind == SourceKind::kGit ? git_tree(std::move(entry)) : archive(std::move(entry));
  }

  Outcome<SourceTree> folder_of(NamedSource entry) const {
    const fs::path folder = roots_.working_directory / entry.place;
    std::error_code error;
    if (!fs::is_directory(folder, error)) return cannot_read(entry.place, "it is not a folder");
    SourceTree tree{.entry = std::move(entry), .locked = {}, .folder = {}, .can_change = true};
    tree.folder = fs::canonical(folder, error);
    if (error) return cannot_read(folder, error.value());
    return tree;
  }

  [[nodiscard]] const LockedSource* locked_as(const NamedSource& entry) const {
    const auto found = std::find_if(
        request_.locked.begin(), request_.locked.end(), [&entry](const LockedSource& one) {
          return entry.kind == SourceKind::kGit
                     ? one.git == entry.place && one.revision == entry.revision
                     : one.archive == entry.place &&
                           (entry.sha256.empty() || one.sha256 == entry.sha256);
        });
    return found == request_.locked.end() ? nullptr : &*found;
  }

  [[nodiscard]] Diagnostic not_locked(const NamedSource& entry) const {
    return Diagnostic{.code = "R2W0311",
                      .message = "the source `" + entry.name + "` is not in the lock",
                      .span = entry.span,
                      .fix = {"ros2wasm lock"}};
  }

  /// As it lies in the cache; nothing when it does not, or not as it was.
  std::optional<fs::path> cached(const std::string& key, const std::string& stamp) const {
    const fs::path place = source_place(roots_.cache, key);
    if (!is_kept(place, stamp)) return std::nullopt;
    if (source_fault(place).empty()) return place / kTree;
    // Another process may have made it again meanwhile.
    const auto lock = FileLock::take(place.string() + ".lock", cancellation_);
    if (is_kept(place, stamp) && source_fault(place).empty()) return place / kTree;
    (void)remove_tree(place);  // it is made again, which reports what cannot be written
    return std::nullopt;
  }

  /// The tree that a commit of the cache has. cached() compares it with the seal.
  [[nodiscard]] std::string cached_tree_of(const std::string& commit) const {
    const auto stamp = read_file(source_place(roots_.cache, commit) / kKeptStamp, kMostOfText);
    const std::string begin = commit + " ";
    return stamp && stamp->starts_with(begin) ? stamp->substr(begin.size()) : std::string();
  }

  [[nodiscard]] std::optional<fs::path> carried(const std::string& key) const {
    if (!request_.takes_carried) return std::nullopt;
    const fs::path folder = roots_.working_directory / kCarriedSources / key;
    std::error_code error;
    if (!fs::is_directory(folder, error)) return std::nullopt;
    fs::path real = fs::canonical(folder, error);
    return error ? std::nullopt : std::optional<fs::path>(std::move(real));
  }

  Outcome<Done> keep(const TemporaryDirectory& beside, const std::string& key,
                     const std::string& stamp) const {
    const fs::path made = beside.path() / "source";
    const fs::path place = source_place(roots_.cache, key);
    if (auto folder = make_directories(place.parent_path()); !folder) return folder;
    const auto seal = tree_seal(made, kKeptStamp, cancellation_);
    if (!seal) return seal.errors();
    if (auto sealed = write_file(seal_place(place), stamp + "\n" + *seal); !sealed) return sealed;
    return keep_folder(made, place, stamp);
  }

  Outcome<SourceTree> git_tree(NamedSource entry) {
    const LockedSource* const locked = locked_as(entry);
    if (locked == nullptr && request_.must_be_locked) return not_locked(entry);
    LockedSource names{.git = entry.place,
                       .revision = entry.revision,
                       .commit = is_commit_hash(entry.revision) ? entry.revision : "",
                       .tree = {},
                       .archive = {},
                       .sha256 = {}};
    if (locked != nullptr) names = *locked;
    names.package.clear();  // who asks by a distribution says so
    SourceTree tree{.entry = std::move(entry), .locked = {}, .folder = {}};
    if (!names.commit.empty()) {
      if (auto folder = carried(names.commit); folder && locked != nullptr) {
        tree.folder = std::move(*folder);
        tree.locked = std::move(names);
        tree.is_carried = true;
        return tree;
      }
      if (names.tree.empty()) names.tree = cached_tree_of(names.commit);
      if (auto folder = cached(names.commit, names.commit + " " + names.tree)) {
        tree.folder = std::move(*folder);
        tree.locked = std::move(names);
        return tree;
      }
    }
    return fetch_git(std::move(tree), std::move(names), locked != nullptr);
  }

  Outcome<SourceTree> fetch_git(SourceTree tree, LockedSource names, bool is_locked) {
    const NamedSource& entry = tree.entry;
    auto beside =
        TemporaryDirectory::make(roots_.cache / "sources" / "unfinished", entry.name + ".");
    if (!beside) return std::move(beside).errors();
    GitTree git(entry.name, beside->path(), limits_, roots_.network.offline, cancellation_);
    const std::string address = is_source_address(entry.place)
                                    ? entry.place
                                    : (roots_.working_directory / entry.place).string();
    const auto is_known = [&](const GitTree::Names& one) {
      return cached(one.commit, one.commit + " " + one.tree).has_value();
    };
    auto found = git.bring(address, names.commit.empty() ? entry.revision : names.commit,
                           beside->path() / "source" / kTree, is_known);
    if (!found) {
      Diagnostics errors = std::move(found).errors();
      for (Diagnostic& one : errors) {
        if (!is_locked || one.code != "R2W0252") continue;
        one.why.push_back("ros2wasm.lock has this commit of `" + entry.revision + "`");
        one.fix = {"ros2wasm lock --update " + entry.name};
      }
      return errors;
    }
    if (is_locked && found->tree != names.tree)
      return not_taken(entry.name, "its commit " + names.commit + " has the tree " + found->tree +
                                       ", and ros2wasm.lock says " + names.tree);
    names.commit = found->commit;
    names.tree = found->tree;
    const std::string stamp = names.commit + " " + names.tree;
    if (!is_known(*found)) {
      if (auto kept = keep(*beside, names.commit, stamp); !kept) return std::move(kept).errors();
    }
    tree.folder = source_place(roots_.cache, names.commit) / kTree;
    tree.locked = std::move(names);
    tree.left_out = git.take_left_out();
    tree.is_new = true;
    return tree;
  }

  Outcome<SourceTree> archive(NamedSource entry) {
    const LockedSource* const locked = locked_as(entry);
    LockedSource names{.git = {},
                       .revision = {},
                       .commit = {},
                       .tree = {},
                       .archive = entry.place,
                       .sha256 = entry.sha256};
    const bool is_address = is_web_place(entry.place);
    if (locked != nullptr && carried(locked->sha256)) {
      SourceTree tree{.entry = std::move(entry), .locked = *locked, .folder = {}};
      tree.folder = *carried(locked->sha256);
      tree.is_carried = true;
      return tree;
    }
    fs::path file = roots_.working_directory / entry.place;
    if (!is_address) {
      const auto hashes = hash_file(file);
      if (!hashes) return hashes.errors();
      if (!names.sha256.empty() && hashes->sha256 != names.sha256)
        return other_archive(entry, hashes->sha256);
      names.sha256 = hashes->sha256;
    }
    const bool fits = locked != nullptr && locked->sha256 == names.sha256;
    if (!fits && request_.must_be_locked) return not_locked(entry);
    SourceTree tree{.entry = std::move(entry), .locked = names, .folder = {}};
    if (auto folder = cached(names.sha256, names.sha256)) {
      tree.folder = std::move(*folder);
      return tree;
    }
    if (is_address) {
      auto brought = download(tree.entry, names.sha256);
      if (!brought) return std::move(brought).errors();
      file = std::move(*brought);
    }
    if (auto done = unpack(tree.entry, file, names.sha256); !done) return std::move(done).errors();
    tree.folder = source_place(roots_.cache, names.sha256) / kTree;
    tree.is_new = true;
    return tree;
  }

  static Diagnostic other_archive(const NamedSource& entry, const std::string& sha256) {
    return Diagnostic{.code = "R2W0220",
                      .kind = FailureKind::kEnvironment,
                      .message = "`" + entry.place + "` is not the archive that was asked for",
                      .span = entry.span,
                      .why = {"its sha256 is " + sha256 + " instead of " + entry.sha256}};
  }

  /// Beside the archives of packages, and looked after as they are.
  Outcome<fs::path> download(const NamedSource& entry, const std::string& sha256) const {
    const std::vector<WantedFile> wanted{{.what = "the archive of `" + entry.name + "`",
                                          .url = entry.place,
                                          .place = source_archive_place(roots_.cache, sha256),
                                          .size = 0,
                                          .sha256 = sha256,
                                          .md5 = {}}};
    if (roots_.network.offline && file_fault(wanted.front(), wanted.front().place))
      return not_here(entry.place);
    Diagnostics errors;
    bring_verified(wanted, roots_.network, cancellation_, [&](std::size_t, Outcome<Done> outcome) {
      if (!outcome) append(errors, outcome.errors());
    });
    if (cancellation_.requested()) return interrupted();
    if (!errors.empty()) return errors;
    return wanted.front().place;
  }

  Outcome<Done> unpack(const NamedSource& entry, const fs::path& file, const std::string& sha256) {
    std::error_code error;
    const std::uint64_t packed = fs::file_size(file, error);
    if (error) return cannot_read(file, error.value());
    auto beside =
        TemporaryDirectory::make(roots_.cache / "sources" / "unfinished", entry.name + ".");
    if (!beside) return std::move(beside).errors();
    const fs::path folder = beside->path() / "source" / kTree;
    if (auto made = make_directories(folder); !made) return made;
    Unpacker unpacker(folder, entry.name, limits_, packed, cancellation_);
    auto visited = visit_source_archive(file, entry.name,
                                        [&](const ArchiveMember& member, const ByteSource& bytes) {
                                          return unpacker.member(member, bytes);
                                        });
    if (!visited) return visited;
    if (auto done = unpacker.write_links(); !done) return done;
    return keep(*beside, sha256, sha256);
  }

  const SourceTreesRequest& request_;
  const ChannelRoots& roots_;
  const ExtractLimits& limits_;
  const Cancellation& cancellation_;
  const ProgressSink& progress_;
};

}  // namespace

std::string key_of(const LockedSource& source) {
  return source.git.empty() ? source.sha256 : source.commit;
}

fs::path source_place(const fs::path& cache, const std::string& key) {
  return cache / "sources" / key.substr(0, 2) / key;
}

fs::path source_archive_place(const fs::path& cache, const std::string& sha256) {
  return cache / "archives" / sha256.substr(0, 2) / sha256 / "source";
}

std::string source_fault(const fs::path& place) {
  const auto is = tree_seal(place, kKeptStamp, {});
  const auto was = read_file(seal_place(place), kMostOfData);
  const auto stamp = read_file(place / kKeptStamp, kMostOfText);
  return is && was && stamp && *stamp + "\n" + *is == *was
             ? ""
             : "its files are not those that were fetched";
}

Outcome<std::vector<SourceTree>> bring_source_trees(const SourceTreesRequest& request,
                                                    const ChannelRoots& roots,
                                                    const ExtractLimits& limits,
                                                    const Cancellation& cancellation,
                                                    const ProgressSink& progress) {
  return Bringer(request, roots, limits, cancellation, progress).bring();
}

Outcome<Done> fetch_source_trees(const std::vector<LockedSource>& sources,
                                 const ChannelRoots& roots, const ExtractLimits& limits,
                                 const Cancellation& cancellation) {
  SourceTreesRequest request{.entries = {}, .locked = sources, .must_be_locked = true};
  for (const LockedSource& one : sources) {
    const bool is_git = !one.git.empty();
    request.entries.push_back({.kind = is_git ? SourceKind::kGit : SourceKind::kArchive,
                               .place = is_git ? one.git : one.archive,
                               .revision = one.revision,
                               .sha256 = one.sha256,
                               .name = source_name(is_git ? one.git : one.archive),
                               .repos = {},
                               .packages = {},
                               .package_places = {},
                               .span = {}});
  }
  const auto brought = bring_source_trees(request, roots, limits, cancellation, {});
  if (!brought) return brought.errors();
  return Done{};
}

}  // namespace ros2wasm
