// See tree_seal.hpp.
#include "bundler/store/tree_seal.hpp"

#include <algorithm>
#include <vector>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/io/worker_pool.hpp"

namespace ros2wasm {
namespace {

std::string line_of(const std::filesystem::path& root, const TreeEntry& entry) {
  switch (entry.kind) {
    case FileKind::kFile: {
      const auto hashes = hash_file(root / entry.path);
      return (hashes ? hashes->sha256 : std::string("unreadable")) +
             (entry.executable ? " x " : " - ") + entry.path + "\n";
    }
    case FileKind::kLink:
      return "link " + entry.link_target + " " + entry.path + "\n";
    case FileKind::kDirectory:
      return "folder " + entry.path + "\n";
    case FileKind::kOther:
      break;
  }
  return "other " + entry.path + "\n";
}

}  // namespace

Outcome<std::string> tree_seal(const std::filesystem::path& root, std::string_view except,
                               const Cancellation& cancellation) {
  const auto entries = list_tree(root);
  if (!entries) return entries.errors();
  std::vector<std::string> lines(entries->size());
  {
    WorkerPool pool;
    constexpr std::size_t kStep = 64;  // entries per task: most files are small
    for (std::size_t begin = 0; begin < lines.size(); begin += kStep) {
      pool.add([&, begin] {
        for (std::size_t i = begin; i < std::min(begin + kStep, lines.size()); ++i) {
          if (!cancellation.requested() && (*entries)[i].path != except)
            lines[i] = line_of(root, (*entries)[i]);
        }
      });
    }
  }
  if (cancellation.requested()) return interrupted();
  std::string seal;
  for (const std::string& line : lines) seal += line;
  return seal;
}

}  // namespace ros2wasm
