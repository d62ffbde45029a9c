// See package_reader.hpp. Files are written as they come; links only when all files are there, so
// that nothing is ever written through a link.
#include "bundler/archive/package_reader.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <optional>
#include <set>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/link_rules.hpp"
#include "bundler/archive/package_lists.hpp"
#include "bundler/archive/zip_files.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/suggestion.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

struct WrittenFile {
  std::string sha256;
  std::uint64_t size = 0;
};

Diagnostic refused(DiagnosticCode code, const std::string& name, const std::string& why) {
  return refused_archive(code, name, {why, "nothing of it was stored"});
}

class Unpacker {
 public:
  Unpacker(const fs::path& directory, const std::string& name, const ExtractLimits& limits,
           std::uint64_t packed_bytes, const Cancellation& cancellation)
      : directory_(directory),
        name_(name),
        meter_(limits, name, packed_bytes),
        cancellation_(cancellation) {}

  Outcome<Done> member(const ArchiveMember& member, const ByteSource& bytes) {
    if (cancellation_.requested()) return interrupted();
    if (auto counted = meter_.member(); !counted) return counted;
    const auto path = safe_member_path(member.path);
    if (!path) {
      // Some tars begin with a member for the folder itself.
      if (member.kind == MemberKind::kDirectory && (member.path == "." || member.path == "./"))
        return Done{};
      return refused("R2W0222", name_,
                     "the member `" + printable(member.path) + "` leads outside of the package");
    }
    switch (member.kind) {
      case MemberKind::kDirectory:
        return make_folder(*path);
      case MemberKind::kFile:
        return file(*path, member.executable, bytes);
      case MemberKind::kLink:
        return link(*path, member.target);
      case MemberKind::kHardLink:
        return hard_link(*path, member.target);
      case MemberKind::kOther:
        break;
    }
    return refused("R2W0222", name_,
                   "the member `" + *path + "` is neither a file, a link nor a directory");
  }

  Outcome<UnpackedPackage> finish() {
    if (auto done = write_hard_links(); !done) return std::move(done).errors();
    if (auto done = write_links(); !done) return std::move(done).errors();
    const auto lists = read_package_lists(directory_);
    if (!lists) return lists.errors();
    const auto entries = package_paths(*lists, name_);
    if (!entries) return entries.errors();
    if (auto done = restore_empty_links(*entries); !done) return std::move(done).errors();
    if (auto done = check_paths(*entries, *lists); !done) return std::move(done).errors();
    return UnpackedPackage{.files = files_.size() + links_.size(), .bytes = meter_.total_bytes()};
  }

 private:
  static std::string printable(std::string_view text) {
    std::string out;
    for (const char c : text.substr(0, 200)) out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    return out;
  }

  /// Claims a name for one file or link. The same name, or one that differs in letter case only,
  /// may not come twice.
  Outcome<Done> claim(const std::string& path) {
    const auto [found, fresh] = claimed_.emplace(ascii_lower(path), path);
    if (fresh) return Done{};
    return refused("R2W0224", name_,
                   found->second == path
                       ? "it has `" + path + "` twice"
                       : "`" + found->second + "` and `" + path + "` differ in letter case only");
  }

  Outcome<Done> make_folder(const std::string& path) {
    std::error_code error;
    fs::create_directories(directory_ / path, error);
    // A file where a folder should be: both cannot be.
    if (error == std::errc::not_a_directory || error == std::errc::file_exists) {
      return refused("R2W0224", name_, "`" + path + "` is both a file and a folder");
    }
    if (error) return cannot_write(directory_ / path, error.value());
    return Done{};
  }

  Outcome<Done> make_folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? Outcome<Done>(Done{}) : make_folder(path.substr(0, slash));
  }

  Outcome<Done> file(const std::string& path, bool executable, const ByteSource& bytes) {
    if (auto claimed = claim(path); !claimed) return claimed;
    if (auto made = make_folder_of(path); !made) return made;
    const fs::path place = directory_ / path;
    const int fd =
        ::open(place.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (fd < 0) {
      const int failed = errno;
      if (failed == EEXIST || failed == EISDIR) {
        return refused("R2W0224", name_, "`" + path + "` is both a file and a folder");
      }
      return cannot_write(place, failed);
    }
    auto written = copy(bytes, fd, place);
    if (written && ::fchmod(fd, executable ? 0555 : 0444) != 0)
      written = cannot_write(place, errno);
    if (::close(fd) != 0 && written) written = cannot_write(place, errno);
    if (!written) return std::move(written).errors();
    files_.emplace(path, std::move(*written));
    return Done{};
  }

  Outcome<WrittenFile> copy(const ByteSource& bytes, int fd, const fs::path& place) {
    Hasher hasher;
    WrittenFile written;
    for (;;) {
      auto piece = bytes();
      if (!piece) return std::move(piece).errors();
      if (piece->empty()) break;
      if (auto counted = meter_.bytes(piece->size()); !counted) return std::move(counted).errors();
      if (cancellation_.requested()) return interrupted();
      hasher.add(*piece);
      written.size += piece->size();
      for (std::string_view rest = *piece; !rest.empty();) {
        const ssize_t done = ::write(fd, rest.data(), rest.size());
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) return cannot_write(place, errno);
        rest.remove_prefix(static_cast<std::size_t>(done));
      }
    }
    written.sha256 = hasher.hex();
    return written;
  }

  Outcome<Done> link(const std::string& path, const std::string& target) {
    if (auto claimed = claim(path); !claimed) return claimed;
    if (target.empty()) {
      empty_links_.push_back(path);
      return Done{};
    }
    if (!link_stays_inside(path, target)) {
      return refused("R2W0223", name_,
                     "the link `" + path + "` leads outside, to `" + printable(target) + "`");
    }
    links_.emplace(path, target);
    return Done{};
  }

  Outcome<Done> hard_link(const std::string& path, const std::string& target) {
    if (auto claimed = claim(path); !claimed) return claimed;
    const auto inside = safe_member_path(target);
    if (!inside) {
      return refused("R2W0223", name_,
                     "the hard link `" + path + "` leads outside, to `" + printable(target) + "`");
    }
    hard_links_.emplace_back(path, *inside);
    return Done{};
  }

  /// A hard link is another name of a file that came before it.
  Outcome<Done> write_hard_links() {
    for (const auto& [path, target] : hard_links_) {
      const auto found = files_.find(target);
      if (found == files_.end()) {
        return refused(
            "R2W0223", name_,
            "the hard link `" + path + "` leads to `" + target + "`, which is not a file of it");
      }
      if (auto made = make_folder_of(path); !made) return made;
      std::error_code error;
      fs::create_hard_link(directory_ / target, directory_ / path, error);
      if (error) return cannot_write(directory_ / path, error.value());
      files_.emplace(path, found->second);
    }
    return Done{};
  }

  Outcome<Done> write_links() {
    for (const auto& [path, target] : links_) {
      // The folder of a link must be a real one: no other link may stand on the way.
      for (std::size_t slash = path.find('/'); slash != std::string::npos;
           slash = path.find('/', slash + 1)) {
        if (links_.contains(path.substr(0, slash))) {
          return refused("R2W0224", name_,
                         "`" + path.substr(0, slash) + "` is both a link and a folder");
        }
      }
      if (auto made = make_folder_of(path); !made) return made;
      std::error_code error;
      fs::create_symlink(target, directory_ / path, error);
      if (error == std::errc::file_exists) {
        return refused("R2W0224", name_, "`" + path + "` is both a link and a folder");
      }
      if (error) return cannot_write(directory_ / path, error.value());
    }
    return Done{};
  }

  /// Some old archives lost the targets of their links. What a link led to is known by its sha256
  /// all the same.
  Outcome<Done> restore_empty_links(const std::map<std::string, PathEntry>& entries) {
    for (const std::string& path : empty_links_) {
      const auto entry = entries.find(path);
      if (entry == entries.end() || entry->second.sha256.empty())
        continue;  // check_paths() says that it is missing
      const auto same = std::find_if(files_.begin(), files_.end(), [&](const auto& file) {
        return !file.first.starts_with("info/") &&
               file.second.sha256 == ascii_lower(entry->second.sha256);
      });
      if (same == files_.end()) continue;
      if (auto made = make_folder_of(path); !made) return made;
      std::error_code error;
      fs::create_hard_link(directory_ / same->first, directory_ / path, error);
      if (error) return cannot_write(directory_ / path, error.value());
      files_.emplace(path, same->second);
    }
    return Done{};
  }

  Outcome<Done> check_paths(const std::map<std::string, PathEntry>& entries,
                            const PackageLists& lists) {
    std::vector<std::string> faults;
    for (const auto& [path, entry] : entries) {
      if (auto fault = path_fault(path, entry)) faults.push_back(std::move(*fault));
    }
    for (const auto& [path, written] : files_) {
      if (!path.starts_with("info/") && !entries.contains(path))
        faults.push_back("`" + path + "` is not listed");
    }
    for (const auto& [path, target] : links_) {
      if (!path.starts_with("info/") && !entries.contains(path))
        faults.push_back("`" + path + "` is not listed");
    }
    if (faults.empty()) return Done{};
    Diagnostic error =
        refused("R2W0226", name_,
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
        if (links_.contains(path)) return std::nullopt;
        // Old archives hold a copy in place of a link; then it must be the right one.
        [[fallthrough]];
      case PathKind::kFile: {
        if (entry.kind == PathKind::kFile && links_.contains(path)) return std::nullopt;
        const auto found = files_.find(path);
        if (found == files_.end()) return quoted + " is missing";
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

  const fs::path& directory_;
  const std::string& name_;
  ExtractMeter meter_;
  const Cancellation& cancellation_;
  std::map<std::string, std::string> claimed_;  ///< lower case -> as it came
  std::map<std::string, WrittenFile> files_;
  std::map<std::string, std::string> links_;
  std::vector<std::string> empty_links_;  ///< links whose target the archive does not say
  std::vector<std::pair<std::string, std::string>> hard_links_;
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
      return refused("R2W0224", name, "it has two parts of the kind `" + member.path + "`");
    }
    return visit_tar(bytes, name, in_tar);
  };
  const bool is_zip = archive.extension() == ".conda";
  auto visited = is_zip ? visit_zip(archive, name, in_zip) : visit_tar_file(archive, name, in_tar);
  if (!visited) return std::move(visited).errors();
  if (is_zip && !parts.contains("info")) return damaged_archive(name, "it has no info part");
  return unpacker.finish();
}

}  // namespace ros2wasm
