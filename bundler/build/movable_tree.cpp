// See movable_tree.hpp.
#include "bundler/build/movable_tree.hpp"

#include <algorithm>
#include <array>

#include "bundler/build/link_kit.hpp"
#include "bundler/build/source_hash.hpp"
#include "bundler/io/files.hpp"
#include "bundler/workspace/share_tree.hpp"
#include "workspace_schema/base/replaced_text.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr auto kCompiled = std::to_array<std::string_view>({".a", ".o", ".so", ".wasm"});
/// Notes that the build leaves in a prefix, and scripts that set up a shell.
bool is_skipped(const std::string& path) {
  if (path.starts_with('.') || path.ends_with(".left_out")) return true;
  if (path.starts_with("share/ament_index/resource_index/parent_prefix_path/")) return true;
  const fs::path file(path);
  const fs::path folder = file.parent_path();
  return folder.has_parent_path() && folder.parent_path() == "share" &&
         sets_up_shell(file.filename());
}

bool is_code(const std::string& path) {
  return std::any_of(kCompiled.begin(), kCompiled.end(),
                     [&path](std::string_view suffix) { return path.ends_with(suffix); });
}

bool names_one(std::string_view bytes, const std::vector<fs::path>& folders) {
  return std::any_of(folders.begin(), folders.end(), [bytes](const fs::path& one) {
    return bytes.find(one.native()) != std::string_view::npos;
  });
}

/// Copies one file; false when it names this machine all the same.
Outcome<bool> copy_movable(const fs::path& from, const TreeEntry& entry, const BuildPlaces& places,
                           const fs::path& to) {
  auto bytes = read_file(from / entry.path, kMostOfData);
  if (!bytes) return std::move(bytes).errors();
  if (bytes->find('\0') == std::string::npos) {
    for (const fs::path& one : places.prefixes)
      *bytes = with_replaced(*bytes, one.string(), kMovablePrefix);
  }
  if (auto done = write_file(to / entry.path, *bytes); !done) return std::move(done).errors();
  if (entry.executable) {
    std::error_code error;
    fs::permissions(to / entry.path,
                    fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add, error);
    if (error) return cannot_write(to / entry.path, error.value());
  }
  return !names_one(*bytes, places.prefixes) && !names_one(*bytes, places.others);
}

Outcome<Done> copy_link(const TreeEntry& entry, const fs::path& to) {
  if (auto made = make_directories((to / entry.path).parent_path()); !made) return made;
  std::error_code error;
  fs::create_symlink(entry.link_target, to / entry.path, error);
  if (error) return cannot_write(to / entry.path, error.value());
  return Done{};
}

/// As they were given, and with links followed: tools write either. The root and folders without a
/// name are left to themselves.
std::vector<fs::path> spellings(const std::vector<fs::path>& folders) {
  std::vector<fs::path> result;
  for (const fs::path& one : folders) {
    if (one.relative_path().empty()) continue;
    result.push_back(one);
    if (const auto real = real_path(one); real && *real != one) result.push_back(*real);
  }
  return result;
}

}  // namespace

Outcome<MovableTree> make_movable(const fs::path& prefix, const std::string& package,
                                  const BuildPlaces& places, const fs::path& to) {
  const auto entries = list_tree(prefix);
  if (!entries) return entries.errors();
  const BuildPlaces known{.prefixes = spellings(places.prefixes),
                          .others = spellings(places.others)};
  MovableTree tree;
  for (const TreeEntry& entry : *entries) {
    if (is_skipped(entry.path)) continue;
    if (entry.kind == FileKind::kLink) {
      if (auto done = copy_link(entry, to); !done) return std::move(done).errors();
      continue;
    }
    if (entry.kind != FileKind::kFile) continue;
    // Kits are rewritten below, from what they say here.
    const bool is_kit = entry.path.starts_with(kLinkKitFolder);
    const auto moves = copy_movable(prefix, entry, is_kit ? BuildPlaces() : known, to);
    if (!moves) return moves.errors();
    if (!*moves) tree.fixed.push_back(entry.path);
    tree.is_compiled = tree.is_compiled || is_code(entry.path);
  }
  if (auto done = make_kits_movable(to, package, known.prefixes); !done)
    return std::move(done).errors();
  auto hash = hash_of_tree(to);
  if (!hash) return std::move(hash).errors();
  tree.hash = *std::move(hash);
  return tree;
}

}  // namespace ros2wasm
