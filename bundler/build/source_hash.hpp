// The hash of a folder's contents: names, executable bits and bytes, nothing of times or owners.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The part of the hash for a link that leads to a folder outside.
enum class LinksOut {
  kNamed,   ///< where the link leads
  kHashed,  ///< what is there, too, for builds that read it: of its first 20,000 files and folders
            ///< the bytes, and past 64 MB of them, or where they cannot be read, sizes and times
};

/// The hash of the files that source_tree() finds. R2W0210 when a file cannot be read.
[[nodiscard]] Outcome<std::string> hash_of_tree(const std::filesystem::path& folder,
                                                const std::filesystem::path& workspace = {},
                                                LinksOut links_out = LinksOut::kNamed);

/// Collects named parts; the order in which they are added matters.
class HashBuilder {
 public:
  HashBuilder& add(std::string_view name, std::string_view value);
  [[nodiscard]] std::string finish() const;

 private:
  std::string text_;
};

}  // namespace ros2wasm
