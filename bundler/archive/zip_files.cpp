// See zip_files.hpp.
#include "bundler/archive/zip_files.hpp"

#include <system_error>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/link_rules.hpp"
#include "bundler/io/files.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// Every member that may be kept.
class Collector {
 public:
  Collector(const std::string& name, const ExtractLimits& limits, std::uint64_t packed_bytes)
      : name_(name), meter_(limits, name, packed_bytes) {}

  Outcome<Done> member(const ArchiveMember& member, const ByteSource& source) {
    if (auto counted = meter_.member(); !counted) return counted;
    const auto path = safe_member_path(member.path);
    if (!path) return refused_archive("R2W0222", name_, {"a member leads outside of the archive"});
    if (member.kind == MemberKind::kDirectory) return Done{};
    if (member.kind != MemberKind::kFile)
      return refused_archive("R2W0223", name_,
                             {"the member `" + *path + "` is not a file, but a link"});
    const auto [found, is_new] = claimed_.emplace(ascii_lower(*path), *path);
    if (!is_new) {
      return refused_archive(
          "R2W0224", name_,
          {"`" + found->second + "` and `" + *path + "` are one file on some machines"});
    }
    ZipFile file{.bytes = {}, .executable = member.executable};
    for (;;) {
      const auto piece = source();
      if (!piece) return piece.errors();
      if (piece->empty()) break;
      if (auto counted = meter_.bytes(piece->size()); !counted) return counted;
      file.bytes += *piece;
    }
    files_.emplace(*path, std::move(file));
    return Done{};
  }

  std::map<std::string, ZipFile> take() { return std::move(files_); }

 private:
  const std::string& name_;
  ExtractMeter meter_;
  std::map<std::string, std::string> claimed_;  ///< lower case -> as it came
  std::map<std::string, ZipFile> files_;
};

}  // namespace

Outcome<std::map<std::string, ZipFile>> read_zip_files(const fs::path& file,
                                                       const std::string& name,
                                                       const ExtractLimits& limits) {
  std::error_code error;
  const std::uint64_t packed_bytes = fs::file_size(file, error);
  if (error) return cannot_read(file, error.value());
  Collector collector(name, limits, packed_bytes);
  const auto visited =
      visit_zip(file, name, [&](const ArchiveMember& member, const ByteSource& bytes) {
        return collector.member(member, bytes);
      });
  if (!visited) return visited.errors();
  return collector.take();
}

Diagnostic refused_archive(DiagnosticCode code, const std::string& name,
                           std::vector<std::string> why) {
  return Diagnostic{.code = code,
                    .kind = FailureKind::kEnvironment,
                    .message = "the archive of `" + name + "` was refused",
                    .why = std::move(why)};
}

}  // namespace ros2wasm
