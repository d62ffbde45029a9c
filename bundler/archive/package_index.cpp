// See package_index.hpp.
#include "bundler/archive/package_index.hpp"

#include <optional>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/link_rules.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kLargestIndex = 16U << 20U;

Outcome<std::string> collect(const ByteSource& bytes, const std::string& name) {
  std::string text;
  for (;;) {
    auto piece = bytes();
    if (!piece) return std::move(piece).errors();
    if (piece->empty()) return text;
    text += *piece;
    if (text.size() > kLargestIndex)
      return damaged_archive(name, "info/index.json is larger than 16 MiB");
  }
}

}  // namespace

Outcome<std::string> read_index_json(const std::filesystem::path& archive,
                                     const std::string& name) {
  std::optional<std::string> index;
  const MemberVisitor in_tar = [&](const ArchiveMember& member,
                                   const ByteSource& bytes) -> Outcome<Done> {
    if (index || member.kind != MemberKind::kFile ||
        safe_member_path(member.path) != "info/index.json") {
      return Done{};
    }
    auto text = collect(bytes, name);
    if (!text) return std::move(text).errors();
    index = std::move(text).value();
    return Done{};
  };
  const MemberVisitor in_zip = [&](const ArchiveMember& member,
                                   const ByteSource& bytes) -> Outcome<Done> {
    if (!member.path.starts_with("info-") || !member.path.ends_with(".tar.zst")) return Done{};
    return visit_tar(bytes, name, in_tar);
  };
  auto visited = archive.extension() == ".conda" ? visit_zip(archive, name, in_zip)
                                                 : visit_tar_file(archive, name, in_tar);
  if (!visited) return std::move(visited).errors();
  if (!index) return damaged_archive(name, "it has no info/index.json");
  return std::move(*index);
}

}  // namespace ros2wasm
