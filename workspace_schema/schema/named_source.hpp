// ROS packages that lie elsewhere, as `sources:` of the manifest and .repos files name them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

enum class SourceKind {
  kGit,           ///< a git repository: an address, or a folder relative to the manifest
  kArchive,       ///< a tar or ZIP file: an address, or a file relative to the manifest
  kFolder,        ///< a folder relative to the manifest, as it is now
  kRepos,         ///< a .repos file relative to the manifest, which names others
  kDistribution,  ///< a distribution file: an address, or a path relative to the manifest
};

/// One entry.
struct NamedSource {
  SourceKind kind = SourceKind::kGit;
  std::string place;
  std::string revision;  ///< of git: a tag, a branch or a commit; empty: the default branch
  std::string sha256;    ///< of an archive; hex, empty only for a file
  std::string name;      ///< source_name() of the place, for people
  std::string repos;     ///< the .repos file that names it; empty: the manifest does
  std::vector<std::string> packages;       ///< the names asked for; empty: all that are there
  std::vector<SourceSpan> package_places;  ///< of `packages`
  SourceSpan span;                         ///< of the place
};

/// Its key in the manifest: "git", "archive", "folder", "repos", "distribution".
[[nodiscard]] std::string_view source_kind_word(SourceKind kind);

/// Whether `place` is an address of git's or the web's, not a path on this machine.
[[nodiscard]] bool is_source_address(std::string_view place);

/// `navigation2` for `https://example.org/ros/navigation2.git`.
[[nodiscard]] std::string source_name(std::string_view place);

/// Whether an archive or a list is on the web; else its place is a path.
[[nodiscard]] bool is_web_place(std::string_view place);

/// Why an archive or a list is not taken from the place: empty when it is. http and https without a
/// password, or a relative path.
[[nodiscard]] std::string file_place_fault(std::string_view place);

/// How much an address can reach: the web, what the user's ssh keys open, this machine. What a
/// stranger's list names must not reach further than the list itself.
enum class Reach { kWeb, kSsh, kMachine };
[[nodiscard]] Reach reach_of(std::string_view git_address);

/// Why git would not be given the address; empty when it would. https, http, ssh and file, and
/// `user@host:path`.
[[nodiscard]] std::string git_address_fault(std::string_view place);

/// Why git would not be given the revision: empty when it would.
[[nodiscard]] std::string git_revision_fault(std::string_view revision);

}  // namespace ros2wasm
