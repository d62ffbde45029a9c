// See package_listing.hpp.
#include "bundler/archive/package_listing.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "bundler/archive/link_rules.hpp"
#include "bundler/archive/paths_json.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

constexpr std::size_t kLargestJson = 256U << 20U;

struct Gathered {
  ExtractMeter meter;
  PackageListing listing{};
  PackageLists lists{};
  std::optional<std::string> link_json{};

  /// Where the text of this member is wanted.
  std::optional<std::string>* kept(const std::optional<std::string>& path) {
    if (path == "info/paths.json") return &lists.paths_json;
    if (path == "info/files") return &lists.files;
    if (path == "info/has_prefix") return &lists.has_prefix;
    return path == "info/link.json" ? &link_json : nullptr;
  }
};

Outcome<Done> gather(Gathered& gathered, const ArchiveMember& member, const ByteSource& bytes) {
  if (auto counted = gathered.meter.member(); !counted) return counted;
  ListedMember listed{
      .path = member.path, .kind = member.kind, .sha256 = {}, .target = member.target};
  if (member.kind == MemberKind::kFile) {
    std::optional<std::string>* kept = gathered.kept(safe_member_path(member.path));
    if (kept != nullptr) kept->emplace();
    Hasher hasher;
    for (;;) {
      auto piece = bytes();
      if (!piece) return std::move(piece).errors();
      if (piece->empty()) break;
      if (auto counted = gathered.meter.bytes(piece->size()); !counted) return counted;
      hasher.add(*piece);
      listed.size += piece->size();
      if (kept != nullptr && (*kept)->size() < kLargestJson) **kept += *piece;
    }
    listed.sha256 = hasher.hex();
  }
  gathered.listing.members.push_back(std::move(listed));
  return Done{};
}

void compare(Gathered& gathered, const std::string& name) {
  std::vector<ListingFault>& faults = gathered.listing.faults;
  gathered.listing.has_hashes = gathered.lists.has_hashes();
  const auto entries = package_paths(gathered.lists, name);
  if (!entries) {
    faults.push_back({"info/paths.json", entries.errors().front().message});
    return;
  }
  std::map<std::string, const ListedMember*> there;
  for (const ListedMember& member : gathered.listing.members) {
    const auto path = safe_member_path(member.path);
    if (!path) {
      if (member.kind != MemberKind::kDirectory)
        faults.push_back({member.path, "leads outside of the package"});
    } else if (!there.emplace(*path, &member).second && member.kind != MemberKind::kDirectory) {
      faults.push_back({*path, "is there twice"});
    }
  }
  for (const auto& [path, entry] : *entries) {
    const auto found = there.find(path);
    if (found == there.end()) {
      if (entry.kind != PathKind::kDirectory) faults.push_back({path, "is missing"});
    } else if (found->second->kind == MemberKind::kFile && entry.kind != PathKind::kDirectory) {
      if (entry.size_known && entry.size != found->second->size) {
        faults.push_back({path, "has " + std::to_string(found->second->size) +
                                    " bytes instead of " + std::to_string(entry.size)});
      } else if (!entry.sha256.empty() && ascii_lower(entry.sha256) != found->second->sha256) {
        faults.push_back(
            {path, "has the sha256 " + found->second->sha256 + " instead of " + entry.sha256});
      }
    } else if (found->second->kind == MemberKind::kLink && found->second->target.empty()) {
      const bool known = std::any_of(there.begin(), there.end(),
                                     [sha256 = ascii_lower(entry.sha256)](const auto& other) {
                                       return !sha256.empty() && other.second->sha256 == sha256;
                                     });
      if (!known) faults.push_back({path, "is a link without a target"});
    }
  }
  for (const auto& [path, member] : there) {
    if (link_script_package(path)) gathered.listing.link_scripts.push_back(path);
    if (member->kind != MemberKind::kDirectory && !path.starts_with("info/") &&
        !entries->contains(path)) {
      faults.push_back({path, "is not listed"});
    }
  }
  std::stable_sort(faults.begin(), faults.end(),
                   [](const ListingFault& a, const ListingFault& b) { return a.path < b.path; });
}

}  // namespace

Outcome<PackageListing> list_package(const std::filesystem::path& archive,
                                     const ExtractLimits& limits) {
  const std::string name = archive.filename().string();
  std::error_code error;
  const std::uint64_t packed_bytes = std::filesystem::file_size(archive, error);
  if (error) return cannot_read(archive, error.value());
  Gathered gathered{.meter = ExtractMeter(limits, name, packed_bytes)};
  const MemberVisitor in_tar = [&](const ArchiveMember& member, const ByteSource& bytes) {
    return gather(gathered, member, bytes);
  };
  const MemberVisitor in_zip = [&](const ArchiveMember& member,
                                   const ByteSource& bytes) -> Outcome<Done> {
    return member.path.ends_with(".tar.zst") ? visit_tar(bytes, name, in_tar) : Done{};
  };
  auto visited = archive.extension() == ".conda" ? visit_zip(archive, name, in_zip)
                                                 : visit_tar_file(archive, name, in_tar);
  if (!visited) return std::move(visited).errors();
  if (gathered.link_json) {
    auto entry_points = parse_entry_points(*gathered.link_json, name);
    if (entry_points) {
      gathered.listing.entry_points = std::move(*entry_points);
    } else {
      gathered.listing.faults.push_back(
          {"info/link.json", entry_points.errors().front().why.empty()
                                 ? "it is not JSON"
                                 : entry_points.errors().front().why.front()});
    }
  }
  compare(gathered, name);
  return std::move(gathered.listing);
}

}  // namespace ros2wasm
