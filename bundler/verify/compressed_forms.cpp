// See compressed_forms.hpp.
#include "bundler/verify/compressed_forms.hpp"

#include "bundler/archive/brotli.hpp"
#include "bundler/archive/deflate.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

fs::path compressed_form(const fs::path& file, const Compression& form) {
  return file.string() + std::string(form.ending);
}

Outcome<std::string> uncompressed(const Compression& form, std::string_view bytes,
                                  std::uint64_t size, const std::string& name) {
  return form.ending == ".br" ? brotli_unpacked(bytes, size, name) : gunzipped(bytes, size, name);
}

std::optional<std::string> wrong_compressed(const fs::path& file, std::uint64_t size,
                                            const std::string& sha256,
                                            const std::function<bool(std::string_view)>& is_taken) {
  for (const Compression& form : kCompressions) {
    const fs::path place = compressed_form(file, form);
    std::error_code error;
    const fs::file_status status = fs::symlink_status(place, error);
    if (!fs::exists(status) || is_taken(form.ending)) continue;
    // A link, a device, or one that is larger than what it should hold is not read.
    if (!fs::is_regular_file(status) || fs::file_size(place, error) > size || error)
      return std::string(form.ending);
    const auto packed = read_file(place, kMostOfData);
    const auto bytes = packed ? uncompressed(form, *packed, size, place.string())
                              : Outcome<std::string>(packed.errors());
    if (!bytes || sha256_hex(*bytes) != sha256) return std::string(form.ending);
  }
  return std::nullopt;
}

}  // namespace ros2wasm
