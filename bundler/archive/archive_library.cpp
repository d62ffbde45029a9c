// See archive_library.hpp. libarchive is known here only.
#include "bundler/archive/archive_library.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <sys/stat.h>

#include <memory>
#include <optional>
#include <vector>

namespace ros2wasm {
namespace {

using Reader = std::unique_ptr<archive, decltype(&archive_read_free)>;

constexpr std::size_t kPiece = std::size_t{256} * 1024;

std::string reason(archive* reader) {
  const char* text = archive_error_string(reader);
  return text == nullptr ? "it is damaged" : text;
}

std::string text_or_empty(const char* text) {
  return text == nullptr ? std::string() : std::string(text);
}

/// Names are bytes; where the archive says that they are UTF-8, the locale must not matter.
std::string path_of(archive_entry* entry) {
  const char* bytes = archive_entry_pathname(entry);
  return text_or_empty(bytes != nullptr ? bytes : archive_entry_pathname_utf8(entry));
}

ArchiveMember member_of(archive_entry* entry) {
  ArchiveMember member{.path = path_of(entry), .kind = MemberKind::kOther, .target = {}};
  const char* hard_link = archive_entry_hardlink(entry);
  if (hard_link == nullptr) hard_link = archive_entry_hardlink_utf8(entry);
  if (hard_link != nullptr) {
    member.kind = MemberKind::kHardLink;
    member.target = hard_link;
    return member;
  }
  switch (archive_entry_filetype(entry)) {
    case AE_IFREG:
      member.kind = MemberKind::kFile;
      member.executable = (archive_entry_perm(entry) & 0111U) != 0;
      break;
    case AE_IFDIR:
      member.kind = MemberKind::kDirectory;
      break;
    case AE_IFLNK: {
      const char* target = archive_entry_symlink(entry);
      if (target == nullptr) target = archive_entry_symlink_utf8(entry);
      member.kind = MemberKind::kLink;
      member.target = text_or_empty(target);
      break;
    }
    default:
      break;
  }
  return member;
}

Outcome<Done> visit_members(archive* reader, const std::string& name,
                            const MemberVisitor& visitor) {
  std::vector<char> buffer(kPiece);
  const ByteSource bytes = [&]() -> Outcome<std::string_view> {
    const auto got = archive_read_data(reader, buffer.data(), buffer.size());
    if (got < 0) return damaged_archive(name, reason(reader));
    return std::string_view(buffer.data(), static_cast<std::size_t>(got));
  };
  for (;;) {
    archive_entry* entry = nullptr;
    const int status = archive_read_next_header(reader, &entry);
    if (status == ARCHIVE_EOF) return Done{};
    // A warning is about a name in another character set: the bytes are still right.
    if (status != ARCHIVE_OK && status != ARCHIVE_WARN)
      return damaged_archive(name, reason(reader));
    if (auto visited = visitor(member_of(entry), bytes); !visited) return visited;
  }
}

/// Feeds libarchive from another archive's member. A failure of the source is kept, since
/// libarchive only knows that it got nothing.
struct Feed {
  const ByteSource& source;
  std::optional<Diagnostics> failure;
};

la_ssize_t feed(archive* reader, void* data, const void** bytes) {
  auto& state = *static_cast<Feed*>(data);
  auto piece = state.source();
  if (!piece) {
    state.failure = std::move(piece).errors();
    archive_set_error(reader, -1, "the outer archive is damaged");
    return -1;
  }
  *bytes = piece->data();
  return static_cast<la_ssize_t>(piece->size());
}

Reader tar_reader() {
  Reader reader(archive_read_new(), archive_read_free);
  archive_read_support_format_tar(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_read_support_filter_zstd(reader.get());
  return reader;
}

}  // namespace

Diagnostic damaged_archive(const std::string& name, const std::string& why) {
  return Diagnostic{.code = "R2W0221",
                    .kind = FailureKind::kEnvironment,
                    .message = "the archive of `" + name + "` is damaged",
                    .why = {why}};
}

Outcome<Done> visit_zip(const std::filesystem::path& file, const std::string& name,
                        const MemberVisitor& visitor) {
  const Reader reader(archive_read_new(), archive_read_free);
  archive_read_support_format_zip_seekable(reader.get());
  if (archive_read_open_filename(reader.get(), file.c_str(), kPiece) != ARCHIVE_OK) {
    return damaged_archive(name, reason(reader.get()));
  }
  return visit_members(reader.get(), name, visitor);
}

Outcome<Done> visit_tar_file(const std::filesystem::path& file, const std::string& name,
                             const MemberVisitor& visitor) {
  const Reader reader = tar_reader();
  if (archive_read_open_filename(reader.get(), file.c_str(), kPiece) != ARCHIVE_OK) {
    return damaged_archive(name, reason(reader.get()));
  }
  return visit_members(reader.get(), name, visitor);
}

Outcome<Done> visit_source_archive(const std::filesystem::path& file, const std::string& name,
                                   const MemberVisitor& visitor) {
  const Reader reader = tar_reader();
  archive_read_support_format_zip_seekable(reader.get());
  archive_read_support_filter_gzip(reader.get());
  archive_read_support_filter_xz(reader.get());
  if (archive_read_open_filename(reader.get(), file.c_str(), kPiece) != ARCHIVE_OK) {
    return damaged_archive(name, reason(reader.get()));
  }
  return visit_members(reader.get(), name, visitor);
}

Outcome<Done> visit_tar(const ByteSource& packed, const std::string& name,
                        const MemberVisitor& visitor) {
  Feed state{.source = packed, .failure = std::nullopt};
  const Reader reader = tar_reader();
  if (archive_read_open(reader.get(), &state, nullptr, feed, nullptr) != ARCHIVE_OK) {
    if (state.failure) return std::move(*state.failure);
    return damaged_archive(name, reason(reader.get()));
  }
  auto visited = visit_members(reader.get(), name, visitor);
  if (state.failure) return std::move(*state.failure);
  return visited;
}

Outcome<std::string> bzip2_decompressed(std::string_view bytes, std::uint64_t limit_bytes,
                                        const std::string& name) {
  const auto damaged = [&name](const std::string& why) {
    return Diagnostic{.code = "R2W0202",
                      .kind = FailureKind::kEnvironment,
                      .message = "`" + name + "` cannot be decompressed",
                      .why = {why}};
  };
  const Reader reader(archive_read_new(), archive_read_free);
  archive_read_support_format_raw(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_entry* entry = nullptr;
  if (archive_read_open_memory(reader.get(), bytes.data(), bytes.size()) != ARCHIVE_OK ||
      archive_read_next_header(reader.get(), &entry) != ARCHIVE_OK) {
    return damaged(reason(reader.get()));
  }
  if (archive_filter_code(reader.get(), 0) != ARCHIVE_FILTER_BZIP2)
    return damaged("it is not compressed with bzip2");
  std::string out;
  std::string piece(kPiece, '\0');
  for (;;) {
    const auto got = archive_read_data(reader.get(), piece.data(), piece.size());
    if (got < 0) return damaged(reason(reader.get()));
    if (got == 0) return out;
    out.append(piece.data(), static_cast<std::size_t>(got));
    if (out.size() > limit_bytes)
      return damaged("it holds more than " + std::to_string(limit_bytes) + " bytes");
  }
}

}  // namespace ros2wasm
