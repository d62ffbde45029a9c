// Compressed forms of a site's files, beside them as NAME.br and NAME.gz: their names, and whether
// they unpack to the files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct Compression {
  std::string_view ending;    ///< `.br`
  std::string_view encoding;  ///< as HTTP calls it
};

/// The best first.
inline constexpr std::array<Compression, 2> kCompressions{
    {{.ending = ".br", .encoding = "br"}, {.ending = ".gz", .encoding = "gzip"}}};

/// Where a compressed form of `file` is.
[[nodiscard]] std::filesystem::path compressed_form(const std::filesystem::path& file,
                                                    const Compression& form);

/// R2W0202 damaged, or more than `size` bytes. `name` is for messages.
[[nodiscard]] Outcome<std::string> uncompressed(const Compression& form, std::string_view bytes,
                                                std::uint64_t size, const std::string& name);

/// The ending of the first compressed form beside `file` that does not unpack to these bytes.
/// `is_taken` reports whether the site itself has a file with that ending.
[[nodiscard]] std::optional<std::string> wrong_compressed(
    const std::filesystem::path& file, std::uint64_t size, const std::string& sha256,
    const std::function<bool(std::string_view ending)>& is_taken);

}  // namespace ros2wasm
