// The hash of a folder's contents: names, executable bits and bytes, nothing of times or owners.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// Of what source_tree() finds. R2W0210: what cannot be read has no hash.
[[nodiscard]] Outcome<std::string> hash_of_tree(const std::filesystem::path& folder,
                                                const std::filesystem::path& workspace = {});

/// Collects named parts; the order in which they are added matters.
class HashBuilder {
 public:
  HashBuilder& add(std::string_view name, std::string_view value);
  [[nodiscard]] std::string finish() const;

 private:
  std::string text_;
};

}  // namespace ros2wasm
