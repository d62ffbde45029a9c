// See source_hash.hpp.
#include "bundler/build/source_hash.hpp"

#include <cstdint>

#include "bundler/build/source_tree.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostElsewhere = 20'000;
constexpr std::uintmax_t kMostBytesElsewhere = 64'000'000;

/// Such a folder may be all of this machine's files: nothing of it fails a build.
std::string hash_elsewhere(const fs::path& folder) {
  const auto entries = source_tree(folder, {}, kMostElsewhere);
  if (!entries) return "unread";
  HashBuilder hash;
  std::uintmax_t left = kMostBytesElsewhere;
  for (const SourceEntry& entry : *entries) {
    if (entry.is_folder) {
      hash.add(entry.path, "as " + entry.same_as + " to " + entry.leads_to);
      continue;
    }
    const fs::path file = folder / entry.path;
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    // Files of the kernel have no size, and no end.
    const bool can_be_read = !error && size > 0 && size <= left;
    const auto bytes =
        can_be_read ? read_file(file, kMostOfData) : Outcome<std::string>(std::string());
    if (can_be_read && bytes) {
      left -= size;
      hash.add(entry.path, sha256_hex(*bytes));
    } else {
      const auto time = fs::last_write_time(file, error).time_since_epoch().count();
      hash.add(entry.path, std::to_string(size) + (size == 0 ? "" : " " + std::to_string(time)));
    }
  }
  return hash.finish();
}

}  // namespace

Outcome<std::string> hash_of_tree(const fs::path& folder, const fs::path& workspace,
                                  LinksOut links_out) {
  const auto entries = source_tree(folder, workspace);
  if (!entries) return entries.errors();
  HashBuilder hash;
  for (const SourceEntry& entry : *entries) {
    if (entry.is_folder) {
      if (!entry.same_as.empty()) hash.add(entry.path, "as " + entry.same_as);
      if (!entry.leads_to.empty()) {
        hash.add(entry.path, "to " + entry.leads_to);
        if (links_out == LinksOut::kHashed) hash.add("with", hash_elsewhere(folder / entry.path));
      }
      continue;
    }
    const fs::path file = folder / entry.path;
    std::error_code error;
    const bool executable =
        (fs::status(file, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    const auto bytes = read_file(file, kMostOfData);
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
