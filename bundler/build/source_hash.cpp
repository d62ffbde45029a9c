// See source_hash.hpp.
#include "bundler/build/source_hash.hpp"

#include "bundler/build/source_tree.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

Outcome<std::string> hash_of_tree(const fs::path& folder, const fs::path& workspace) {
  const auto entries = source_tree(folder, workspace);
  if (!entries) return entries.errors();
  HashBuilder hash;
  for (const SourceEntry& entry : *entries) {
    if (entry.is_folder) {
      if (!entry.same_as.empty()) hash.add(entry.path, "as " + entry.same_as);
      if (!entry.leads_to.empty()) hash.add(entry.path, "to " + entry.leads_to);
      continue;
    }
    const fs::path file = folder / entry.path;
    std::error_code error;
    const bool executable =
        (fs::status(file, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    const auto bytes = read_file(file);
    if (!bytes) return bytes.errors();
    hash.add(entry.path, (executable ? "x" : "-") + sha256_hex(*bytes));
  }
  return hash.finish();
}

HashBuilder& HashBuilder::add(std::string_view name, std::string_view value) {
  // Lengths keep ("ab", "c") and ("a", "bc") apart.
  text_ += std::to_string(name.size()) + ":" + std::to_string(value.size()) + ":";
  text_.append(name).append(value);
  return *this;
}

std::string HashBuilder::finish() const {
  return sha256_hex(text_);
}

}  // namespace ros2wasm
