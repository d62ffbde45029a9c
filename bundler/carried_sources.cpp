// See carried_sources.hpp.
#include "bundler/carried_sources.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <system_error>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/link_rules.hpp"
#include "bundler/archive/zip_files.hpp"
#include "bundler/archive/zip_writer.hpp"
#include "bundler/build/source_tree.hpp"
#include "bundler/io/files.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/site/site_names.hpp"
#include "bundler/site_budget.hpp"
#include "bundler/site_components.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// A ZIP without ZIP64 has no more.
constexpr std::uint64_t kMostBytes = 4'000'000'000;
constexpr std::size_t kMostFiles = 65'000;

/// Folders above the workspace, of which a package beside it is named from, are called that.
constexpr const char* kAbove = "workspace";

Diagnostic not_carried(const std::string& what, std::string why) {
  return Diagnostic{.code = "R2W0661",
                    .message = "the site cannot carry `" + what + "`, of which it is made",
                    .why = {std::move(why)},
                    .fix = {"change it, or leave out `sources: true` of the manifest's `site:`"}};
}

class Sources {
 public:
  explicit Sources(const BuiltWorkspace& workspace) : workspace_(workspace) {}

  void add(const fs::path& path) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    const fs::path from_workspace = real.lexically_relative(workspace_.read.folder);
    if (error || from_workspace.empty()) {
      errors_.push_back(not_carried(path.string(), "it is not there"));
      return;
    }
    // Launch files read what was built and installed, too, and what add_trees() adds.
    if (path_within(workspace_.built.settings.cache, real) ||
        path_within(workspace_.fetched.prefix, real))
      return;
    if (path_within(workspace_.supplies.roots.cache / "sources", real)) return;
    add_at(from_workspace, real, workspace_.read.folder);
  }

  /// The packages that came from repositories and archives, where bring_source_trees() finds them.
  void add_trees() {
    for (const SourceTree& tree : workspace_.supplies.source_trees) {
      if (tree.can_change) continue;
      const fs::path place = fs::path(kCarriedSources) / key_of(tree.locked);
      // Patterns of the manifest must not find them once more.
      add_text((fs::path(kCarriedSources) / "COLCON_IGNORE").generic_string(), "");
      // The folder is there even when the workspace has all of its packages.
      add_text((place / "SOURCE").generic_string(),
               tree.locked.git.empty() ? tree.locked.archive + "\n"
                                       : tree.locked.git + "\n" + tree.locked.commit + "\n");
      for (const fs::path& file : license_files(tree.folder))
        add_at(place / file.lexically_relative(tree.folder), file, tree.folder);
      if (!tree.locked.model.empty()) add_at(place, tree.folder, tree.folder);
      for (const LocalPackage& package : workspace_.built.sources) {
        if (package.base != tree.folder) continue;
        add_at((place / package.directory.lexically_relative(tree.folder)).lexically_normal(),
               package.directory, tree.folder);
      }
    }
  }

  void add_text(const std::string& name, std::string text) {
    keep(name, {.bytes = std::move(text), .executable = false});
  }

  void leave_out(const std::string& name) { files_.erase(name); }

  /// The manifest comes first, so that its place is known.
  Outcome<std::string> archive(const std::string& manifest) {
    if (!errors_.empty()) return std::move(errors_);
    std::size_t above = 0;
    for (const auto& [name, file] : files_) above = std::max(above, steps_up(name));
    fs::path place;
    for (std::size_t i = 0; i < above; ++i) place /= kAbove;
    const std::string first = (place / manifest).generic_string();
    std::map<std::string, const ZipFile*> placed;
    std::map<std::string, std::string> claimed;  // lower case -> as it is
    std::uint64_t bytes = 0;
    for (const auto& [name, file] : files_) {
      const std::string path = (place / name).lexically_normal().generic_string();
      if (safe_member_path(path) != path) return not_carried(name, "its name cannot be unpacked");
      const auto [other, fresh] = claimed.emplace(ascii_lower(path), name);
      if (!fresh)
        return not_carried(name, "`" + other->second + "` is the same file on some machines");
      placed.emplace(path, &file);
      bytes += file.bytes.size() + 2 * path.size() + 100;
    }
    if (bytes > kMostBytes || placed.size() > kMostFiles)
      return not_carried(workspace_.read.shown_folder.string(),
                         "an archive holds 4 GB and 65,000 files");
    ZipWriter zip;
    const auto member = [&](const std::string& path, const ZipFile& file) {
      zip.member(path, file.bytes, file.executable);
    };
    member(first, *placed.at(first));
    for (const auto& [path, file] : placed)
      if (path != first) member(path, *file);
    return zip.finish();
  }

 private:
  static std::size_t steps_up(const std::string& name) {
    const fs::path path(name);
    return static_cast<std::size_t>(std::count(path.begin(), path.end(), fs::path("..")));
  }

  /// A file, or all of a folder, by the name that it has in the archive.
  void add_at(const fs::path& name, const fs::path& real, const fs::path& base) {
    std::error_code error;
    if (!fs::is_directory(real, error)) return add_file(name.generic_string(), real);
    const auto entries = source_tree(real, base);
    if (!entries) {
      const Diagnostics& faults = entries.errors();
      errors_.insert(errors_.end(), faults.begin(), faults.end());
      return;
    }
    for (const SourceEntry& entry : *entries) {
      const std::string below = (name / entry.path).lexically_normal().generic_string();
      if (!entry.same_as.empty() || !entry.leads_to.empty()) {
        errors_.push_back(
            not_carried(below, "it is a link to the folder `" +
                                   (entry.same_as.empty() ? entry.leads_to : entry.same_as) + "`"));
      } else if (!entry.is_folder) {
        add_file(below, real / entry.path);
      }
    }
  }

  void add_file(const std::string& name, const fs::path& file) {
    auto bytes = read_file(file, kMostOfData);
    if (!bytes) {
      const Diagnostics& faults = bytes.errors();
      errors_.insert(errors_.end(), faults.begin(), faults.end());
      return;
    }
    std::error_code error;
    const bool executable =
        (fs::status(file, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    keep(name, {.bytes = std::move(*bytes), .executable = executable});
  }

  void keep(const std::string& name, ZipFile file) {
    files_.insert_or_assign(name, std::move(file));
  }

  const BuiltWorkspace& workspace_;
  std::map<std::string, ZipFile> files_;  ///< by path from the workspace's folder
  Diagnostics errors_;
};

}  // namespace

Outcome<Done> add_sources(const PackRequest& request, const BuiltWorkspace& workspace,
                          PlanInput& input, PackNotes& notes) {
  const auto& options = workspace.read.manifest.site;
  const auto asked = options.find("sources");
  if (asked == options.end() || asked->second != "true") return Done{};
  if (request.quick) {
    notes.remarks.emplace_back("the site carries no sources: --quick makes other programs");
    return Done{};
  }
  Sources sources(workspace);
  for (const fs::path& path : notes.watched) sources.add(path);
  for (const fs::path& path : license_files(workspace.read.folder)) sources.add(path);
  sources.add_trees();
  sources.add_text(kLockFileName, workspace.fetched.lock_text);
  sources.leave_out(kSizesFileName);  // written after the site
  // The manifest is the first that a workspace depends on.
  auto archive = sources.archive(notes.watched.front().filename().string());
  if (!archive) return std::move(archive).errors();
  input.sources = std::move(*archive);
  return Done{};
}

Outcome<fs::path> unpack_sources(const fs::path& archive, const fs::path& folder,
                                 const ExtractLimits& limits) {
  std::string manifest;
  const auto first =
      visit_zip(archive, kSourcesArchive,
                [&](const ArchiveMember& member, const ByteSource&) -> Outcome<Done> {
                  if (manifest.empty()) manifest = member.path;
                  return Done{};
                });
  if (!first) return first.errors();
  const auto files = read_zip_files(archive, kSourcesArchive, limits);
  if (!files) return files.errors();
  if (!files->contains(manifest)) return damaged_archive(kSourcesArchive, "it has no manifest");
  for (const auto& [path, file] : *files) {
    if (auto written = write_file(folder / path, file.bytes); !written)
      return std::move(written).errors();
    std::error_code error;
    if (file.executable)
      fs::permissions(folder / path, fs::perms::owner_exec, fs::perm_options::add, error);
  }
  return folder / manifest;
}

}  // namespace ros2wasm
