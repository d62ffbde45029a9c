// Walks through ZIP and tar archives, member by member, without writing anything. libarchive ends
// in archive_library.cpp; names and kinds are handed on as they are in the archive, to be judged by
// the caller.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

enum class MemberKind { kFile, kLink, kHardLink, kDirectory, kOther };

struct ArchiveMember {
  std::string path;
  MemberKind kind = MemberKind::kFile;
  std::string target;  ///< of links and hard links
  bool executable = false;
};

/// The next bytes; empty at the end. Valid until the next call.
using ByteSource = std::function<Outcome<std::string_view>()>;

/// Called for each member in the order of the archive. The source need not be read to its end.
using MemberVisitor =
    std::function<Outcome<Done>(const ArchiveMember& member, const ByteSource& bytes)>;

/// Members of a ZIP file, by its central directory. R2W0221 when damaged; `name` is for messages.
[[nodiscard]] Outcome<Done> visit_zip(const std::filesystem::path& file, const std::string& name,
                                      const MemberVisitor& visitor);

/// Members of a tar file that is compressed with bzip2 or zstd or not at all. R2W0221 when damaged.
[[nodiscard]] Outcome<Done> visit_tar_file(const std::filesystem::path& file,
                                           const std::string& name, const MemberVisitor& visitor);

/// Members of a source archive by its content: ZIP, or tar that is compressed with gzip, bzip2, xz
/// or zstd or not at all. R2W0221 when damaged.
[[nodiscard]] Outcome<Done> visit_source_archive(const std::filesystem::path& file,
                                                 const std::string& name,
                                                 const MemberVisitor& visitor);

/// As visit_tar_file() for a tar that comes out of another archive.
[[nodiscard]] Outcome<Done> visit_tar(const ByteSource& packed, const std::string& name,
                                      const MemberVisitor& visitor);

/// The bytes of one bzip2 stream. R2W0202 when it is damaged or holds more than `limit_bytes`.
[[nodiscard]] Outcome<std::string> bzip2_decompressed(std::string_view bytes,
                                                      std::uint64_t limit_bytes,
                                                      const std::string& name);

/// The diagnostic that a visitor of a whole archive returns when the archive is damaged.
[[nodiscard]] Diagnostic damaged_archive(const std::string& name, const std::string& why);

}  // namespace ros2wasm
