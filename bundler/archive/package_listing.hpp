// The contents of a conda archive, compared with its own info/paths.json. Writes nothing and
// refuses only bombs: for looking at archives, damaged ones too. Unpacking is in
// package_reader.hpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/extract_limits.hpp"
#include "bundler/archive/link_json.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct ListedMember {
  std::string path;  ///< as it is in the archive
  MemberKind kind = MemberKind::kFile;
  std::uint64_t size = 0;
  std::string sha256;  ///< of a file
  std::string target;  ///< of a link
};

struct ListingFault {
  std::string path;
  std::string reason;
};

struct PackageListing {
  std::vector<ListedMember> members;      ///< in the order of the archive
  std::vector<ListingFault> faults;       ///< what does not agree with info/paths.json, by path
  std::vector<EntryPoint> entry_points;   ///< commands that its info/link.json asks for
  bool has_hashes = true;                 ///< false: an old package, which has no info/paths.json
  std::vector<std::string> link_scripts;  ///< paths of programs that conda would run, sorted
};

/// R2W0221 when the archive cannot be read to its end, R2W0225 when it holds more than `limits`,
/// R2W0210.
[[nodiscard]] Outcome<PackageListing> list_package(const std::filesystem::path& archive,
                                                   const ExtractLimits& limits = {});

}  // namespace ros2wasm
