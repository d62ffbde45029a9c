// See package_reader.hpp.
#include "bundler/archive/package_reader.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/package_lists.hpp"
#include "bundler/archive/unpacker.hpp"
#include "bundler/io/files.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// An unpacked archive against the lists in it.
class UnpackedLists {
 public:
  UnpackedLists(Unpacker& unpacker, const fs::path& directory, const std::string& name)
      : unpacker_(unpacker), directory_(directory), name_(name) {}

  Outcome<UnpackedPackage> finish() {
    if (auto done = unpacker_.write_links(); !done) return std::move(done).errors();
    const auto lists = read_package_lists(directory_);
    if (!lists) return lists.errors();
    const auto entries = package_paths(*lists, name_);
    if (!entries) return entries.errors();
    if (auto done = restore_empty_links(*entries); !done) return std::move(done).errors();
    if (auto done = check_paths(*entries, *lists); !done) return std::move(done).errors();
    return UnpackedPackage{.files = unpacker_.files().size() + unpacker_.links().size(),
                           .bytes = unpacker_.total_bytes()};
  }

 private:
  /// Some old archives lost the targets of their links. What a link led to is known by its sha256
  /// all the same.
  Outcome<Done> restore_empty_links(const std::map<std::string, PathEntry>& entries) {
    for (const std::string& path : unpacker_.empty_links()) {
      const auto entry = entries.find(path);
      if (entry == entries.end() || entry->second.sha256.empty())
        continue;  // check_paths() says that it is missing
      const auto same =
          std::find_if(unpacker_.files().begin(), unpacker_.files().end(), [&](const auto& file) {
            return !file.first.starts_with("info/") &&
                   file.second.sha256 == ascii_lower(entry->second.sha256);
          });
      if (same == unpacker_.files().end()) continue;
      if (auto named = unpacker_.add_name(path, same->first); !named) return named;
    }
    return Done{};
  }

  Outcome<Done> check_paths(const std::map<std::string, PathEntry>& entries,
                            const PackageLists& lists) {
    std::vector<std::string> faults;
    for (const auto& [path, entry] : entries) {
      if (auto fault = path_fault(path, entry)) faults.push_back(std::move(*fault));
    }
    for (const auto& [path, written] : unpacker_.files()) {
      if (!path.starts_with("info/") && !entries.contains(path))
        faults.push_back("`" + path + "` is not listed");
    }
    for (const auto& [path, target] : unpacker_.links()) {
      if (!path.starts_with("info/") && !entries.contains(path))
        faults.push_back("`" + path + "` is not listed");
    }
    if (faults.empty()) return Done{};
    Diagnostic error =
        nothing_stored("R2W0226", name_,
                       std::string("its files are not those that its ") +
                           (lists.has_hashes() ? "info/paths.json" : "info/files") + " lists");
    constexpr std::size_t kMostShown = 20;
    for (std::size_t i = 0; i < std::min(faults.size(), kMostShown); ++i)
      error.why.push_back(faults[i]);
    if (faults.size() > kMostShown)
      error.why.push_back("and " + std::to_string(faults.size() - kMostShown) + " more");
    return error;
  }

  [[nodiscard]] std::optional<std::string> path_fault(const std::string& path,
                                                      const PathEntry& entry) const {
    const auto quoted = "`" + path + "`";
    switch (entry.kind) {
      case PathKind::kDirectory: {
        std::error_code error;
        if (!fs::is_directory(fs::symlink_status(directory_ / path, error)))
          return quoted + " is not a folder";
        return std::nullopt;
      }
      case PathKind::kLink:
        if (unpacker_.links().contains(path)) return std::nullopt;
        // Old archives hold a copy in place of a link; then it must be the right one.
        [[fallthrough]];
      case PathKind::kFile: {
        if (entry.kind == PathKind::kFile && unpacker_.links().contains(path)) return std::nullopt;
        const auto found = unpacker_.files().find(path);
        if (found == unpacker_.files().end()) return quoted + " is missing";
        if (entry.size_known && found->second.size != entry.size) {
          return quoted + " has " + std::to_string(found->second.size) + " bytes instead of " +
                 std::to_string(entry.size);
        }
        if (!entry.sha256.empty() && found->second.sha256 != ascii_lower(entry.sha256)) {
          return quoted + " has another sha256 than listed";
        }
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  Unpacker& unpacker_;
  const fs::path& directory_;
  const std::string& name_;
};

}  // namespace

Outcome<UnpackedPackage> unpack_package(const fs::path& archive, const fs::path& directory,
                                        const std::string& name, const ExtractLimits& limits,
                                        const Cancellation& cancellation) {
  std::error_code error;
  const std::uint64_t packed_bytes = fs::file_size(archive, error);
  if (error) return cannot_read(archive, error.value());
  Unpacker unpacker(directory, name, limits, packed_bytes, cancellation);
  const MemberVisitor in_tar = [&](const ArchiveMember& member, const ByteSource& bytes) {
    return unpacker.member(member, bytes);
  };
  std::set<std::string> parts;
  const MemberVisitor in_zip = [&](const ArchiveMember& member,
                                   const ByteSource& bytes) -> Outcome<Done> {
    const bool is_part = member.path.ends_with(".tar.zst") &&
                         (member.path.starts_with("pkg-") || member.path.starts_with("info-"));
    if (!is_part) return Done{};
    if (!parts.insert(member.path.substr(0, member.path.find('-'))).second) {
      return nothing_stored("R2W0224", name, "it has two parts of the kind `" + member.path + "`");
    }
    return visit_tar(bytes, name, in_tar);
  };
  const bool is_zip = archive.extension() == ".conda";
  auto visited = is_zip ? visit_zip(archive, name, in_zip) : visit_tar_file(archive, name, in_tar);
  if (!visited) return std::move(visited).errors();
  if (is_zip && !parts.contains("info")) return damaged_archive(name, "it has no info part");
  return UnpackedLists(unpacker, directory, name).finish();
}

}  // namespace ros2wasm
