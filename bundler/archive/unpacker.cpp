// See unpacker.hpp.
#include "bundler/archive/unpacker.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "bundler/archive/link_rules.hpp"
#include "bundler/archive/zip_files.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 200)) out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  return out;
}

}  // namespace

Diagnostic nothing_stored(DiagnosticCode code, const std::string& name, const std::string& why) {
  return refused_archive(code, name, {why, "nothing of it was stored"});
}

Unpacker::Unpacker(const fs::path& directory, const std::string& name, const ExtractLimits& limits,
                   std::uint64_t packed_bytes, const Cancellation& cancellation)
    : directory_(directory),
      name_(name),
      meter_(limits, name, packed_bytes),
      cancellation_(cancellation) {}

Outcome<Done> Unpacker::write_links() {
  if (auto done = write_hard_links(); !done) return done;
  return write_symbolic_links();
}

Outcome<Done> Unpacker::add_name(const std::string& path, const std::string& file) {
  if (auto made = make_folder_of(path); !made) return made;
  std::error_code error;
  fs::create_hard_link(directory_ / file, directory_ / path, error);
  if (error) return cannot_write(directory_ / path, error.value());
  files_.emplace(path, files_.at(file));
  return Done{};
}

Outcome<Done> Unpacker::member(const ArchiveMember& member, const ByteSource& bytes) {
  if (cancellation_.requested()) return interrupted();
  if (auto counted = meter_.member(); !counted) return counted;
  const auto path = safe_member_path(member.path);
  if (!path) {
    // Some tars begin with a member for the folder itself.
    if (member.kind == MemberKind::kDirectory && (member.path == "." || member.path == "./"))
      return Done{};
    return nothing_stored(
        "R2W0222", name_,
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
  return nothing_stored("R2W0222", name_,
                        "the member `" + *path + "` is neither a file, a link nor a directory");
}

/// Claims a name for one file or link. The same name, or one that differs in letter case only,
/// may not come twice.
Outcome<Done> Unpacker::claim(const std::string& path) {
  const auto [found, fresh] = claimed_.emplace(ascii_lower(path), path);
  if (fresh) return Done{};
  return nothing_stored("R2W0224", name_,
                        found->second == path ? "it has `" + path + "` twice"
                                              : "`" + found->second + "` and `" + path +
                                                    "` differ in letter case only");
}

Outcome<Done> Unpacker::make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(directory_ / path, error);
  // A file where a folder should be: both cannot be.
  if (error == std::errc::not_a_directory || error == std::errc::file_exists) {
    return nothing_stored("R2W0224", name_, "`" + path + "` is both a file and a folder");
  }
  if (error) return cannot_write(directory_ / path, error.value());
  return Done{};
}

Outcome<Done> Unpacker::make_folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? Outcome<Done>(Done{}) : make_folder(path.substr(0, slash));
}

Outcome<Done> Unpacker::file(const std::string& path, bool executable, const ByteSource& bytes) {
  if (auto claimed = claim(path); !claimed) return claimed;
  if (auto made = make_folder_of(path); !made) return made;
  const fs::path place = directory_ / path;
  const int fd = ::open(place.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (fd < 0) {
    const int failed = errno;
    if (failed == EEXIST || failed == EISDIR) {
      return nothing_stored("R2W0224", name_, "`" + path + "` is both a file and a folder");
    }
    return cannot_write(place, failed);
  }
  auto written = copy(bytes, fd, place);
  if (written && ::fchmod(fd, executable ? 0555 : 0444) != 0) written = cannot_write(place, errno);
  if (::close(fd) != 0 && written) written = cannot_write(place, errno);
  if (!written) return std::move(written).errors();
  files_.emplace(path, std::move(*written));
  return Done{};
}

Outcome<WrittenFile> Unpacker::copy(const ByteSource& bytes, int fd, const fs::path& place) {
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

Outcome<Done> Unpacker::link(const std::string& path, const std::string& target) {
  if (auto claimed = claim(path); !claimed) return claimed;
  if (target.empty()) {
    empty_links_.push_back(path);
    return Done{};
  }
  if (!link_stays_inside(path, target)) {
    return nothing_stored("R2W0223", name_,
                          "the link `" + path + "` leads outside, to `" + printable(target) + "`");
  }
  links_.emplace(path, target);
  return Done{};
}

Outcome<Done> Unpacker::hard_link(const std::string& path, const std::string& target) {
  if (auto claimed = claim(path); !claimed) return claimed;
  const auto inside = safe_member_path(target);
  if (!inside) {
    return nothing_stored(
        "R2W0223", name_,
        "the hard link `" + path + "` leads outside, to `" + printable(target) + "`");
  }
  hard_links_.emplace_back(path, *inside);
  return Done{};
}

/// A hard link is another name of a file that came before it.
Outcome<Done> Unpacker::write_hard_links() {
  for (const auto& [path, target] : hard_links_) {
    const auto found = files_.find(target);
    if (found == files_.end()) {
      return nothing_stored(
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

Outcome<Done> Unpacker::write_symbolic_links() {
  for (const auto& [path, target] : links_) {
    // The folder of a link must be a real one: no other link may stand on the way.
    for (std::size_t slash = path.find('/'); slash != std::string::npos;
         slash = path.find('/', slash + 1)) {
      if (links_.contains(path.substr(0, slash))) {
        return nothing_stored("R2W0224", name_,
                              "`" + path.substr(0, slash) + "` is both a link and a folder");
      }
    }
    if (auto made = make_folder_of(path); !made) return made;
    std::error_code error;
    fs::create_symlink(target, directory_ / path, error);
    if (error == std::errc::file_exists) {
      return nothing_stored("R2W0224", name_, "`" + path + "` is both a link and a folder");
    }
    if (error) return cannot_write(directory_ / path, error.value());
  }
  for (const auto& [path, target] : links_) {
    if (!link_ends_inside(directory_, path))
      return nothing_stored("R2W0223", name_,
                            "the link `" + path + "` leads outside by way of another link");
  }
  return Done{};
}

}  // namespace ros2wasm
