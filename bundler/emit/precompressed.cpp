// See precompressed.hpp.
#include "bundler/emit/precompressed.hpp"

#include <algorithm>
#include <set>

#include "bundler/archive/brotli.hpp"
#include "bundler/archive/deflate.hpp"
#include "bundler/io/files.hpp"
#include "bundler/site/site_list.hpp"
#include "bundler/verify/compressed_forms.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// Smaller files are not worth a compressed form.
constexpr std::size_t kLeastBytes = 1000;
/// File types that are compressed already.
constexpr std::array<std::string_view, 7> kPacked{".zip", ".png",  ".jpg", ".jpeg",
                                                  ".gif", ".webp", ".mcap"};

std::string compressed(const Compression& form, std::string_view bytes) {
  return form.ending == ".br" ? brotli_compressed(bytes) : gzipped(bytes);
}

}  // namespace

Outcome<Done> remove_compressed(const fs::path& file) {
  for (const Compression& form : kCompressions) {
    if (auto removed = remove_tree(compressed_form(file, form)); !removed) return removed;
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
    const fs::path place = compressed_form(file, form);
    if (taken.contains(place)) continue;
    std::error_code error;
    // Another site may have written this object and its compressed form.
    if (worth && fs::exists(place, error)) {
      const auto old = read_file(place, kMostOfData);
      const auto inside =
          old ? uncompressed(form, *old, bytes->size(), place.string()) : Outcome<std::string>("");
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

}  // namespace ros2wasm
