// See precompressed.hpp.
#include "bundler/emit/precompressed.hpp"

#include <algorithm>
#include <set>

#include "bundler/archive/brotli.hpp"
#include "bundler/archive/deflate.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/verify/site_list.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Less is not worth a file.
constexpr std::size_t kLeastBytes = 1000;
/// What is compressed already.
constexpr std::array<std::string_view, 7> kPacked{".zip", ".png",  ".jpg", ".jpeg",
                                                  ".gif", ".webp", ".mcap"};

fs::path beside(const fs::path& file, const Compression& form) {
  return file.string() + std::string(form.ending);
}

std::string compressed(const Compression& form, std::string_view bytes) {
  return form.ending == ".br" ? brotli_compressed(bytes) : gzipped(bytes);
}

Outcome<std::string> unpacked(const Compression& form, std::string_view bytes, std::uint64_t size,
                              const std::string& name) {
  return form.ending == ".br" ? brotli_unpacked(bytes, size, name) : gunzipped(bytes, size, name);
}

}  // namespace

Outcome<Done> remove_compressed(const fs::path& file) {
  for (const Compression& form : kCompressions) {
    if (auto removed = remove_tree(beside(file, form)); !removed) return removed;
  }
  return Done{};
}

Outcome<Done> precompress_file(const fs::path& file, const std::set<fs::path>& taken) {
  const auto bytes = read_file(file, kMostOfData);
  if (!bytes) return bytes.errors();
  const std::string ending = file.extension().string();
  const bool worth = bytes->size() >= kLeastBytes &&
                     std::find(kPacked.begin(), kPacked.end(), ending) == kPacked.end();
  for (const Compression& form : kCompressions) {
    const fs::path place = beside(file, form);
    if (taken.contains(place)) continue;
    std::error_code error;
    // Of an object that another site brought.
    if (worth && fs::exists(place, error)) {
      const auto old = read_file(place, kMostOfData);
      const auto inside =
          old ? unpacked(form, *old, bytes->size(), place.string()) : Outcome<std::string>("");
      if (inside && *inside == *bytes) continue;
    }
    const std::string small = worth ? compressed(form, *bytes) : std::string();
    const bool smaller = worth && small.size() < bytes->size();
    auto done = smaller ? write_file(place, small) : remove_tree(place);
    if (!done) return done;
  }
  return Done{};
}

Outcome<Done> precompress_site(const fs::path& folder, const Cancellation& cancellation) {
  const auto text = read_file(folder / kSiteJsonName, kMostOfSiteJson);
  if (!text) return text.errors();
  const auto list = read_site_list(*text, (folder / kSiteJsonName).string());
  if (!list) return list.errors();
  std::set<fs::path> files{(folder / kSiteJsonName).lexically_normal()};
  for (const ListedFile& file : list->files) {
    for (const std::string& place : places_of(file, *list))
      files.insert((folder / place).lexically_normal());
  }
  for (const fs::path& file : files) {
    if (cancellation.requested()) return interrupted();
    if (auto done = precompress_file(file, files); !done) return done;
  }
  return Done{};
}

std::optional<std::string> wrong_compressed(const fs::path& file, std::uint64_t size,
                                            const std::string& sha256,
                                            const std::function<bool(std::string_view)>& is_taken) {
  for (const Compression& form : kCompressions) {
    const fs::path place = beside(file, form);
    std::error_code error;
    const fs::file_status status = fs::symlink_status(place, error);
    if (!fs::exists(status) || is_taken(form.ending)) continue;
    // A link, a device, or one that is larger than what it should hold is not read.
    if (!fs::is_regular_file(status) || fs::file_size(place, error) > size || error)
      return std::string(form.ending);
    const auto packed = read_file(place, kMostOfData);
    const auto bytes = packed ? unpacked(form, *packed, size, place.string())
                              : Outcome<std::string>(packed.errors());
    if (!bytes || sha256_hex(*bytes) != sha256) return std::string(form.ending);
  }
  return std::nullopt;
}

}  // namespace ros2wasm
