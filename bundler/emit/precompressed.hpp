// Compressed forms of a site's files, beside them as NAME.br and NAME.gz, for hosts that send those
// in place of the files (nginx's gzip_static and brotli_static, and others). They are no part of a
// site and of its hash: what comes out of them is.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "workspace_schema/cancellation.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

struct Compression {
  std::string_view ending;    ///< `.br`
  std::string_view encoding;  ///< as HTTP calls it
};

/// The best first.
inline constexpr std::array<Compression, 2> kCompressions{
    {{.ending = ".br", .encoding = "br"}, {.ending = ".gz", .encoding = "gzip"}}};

/// Writes both where they are smaller, and removes those that are not of these bytes; leaves what
/// is `taken`, the site's own files. R2W0210, R2W0211.
[[nodiscard]] Outcome<Done> precompress_file(const std::filesystem::path& file,
                                             const std::set<std::filesystem::path>& taken = {});

/// Of no file that has other bytes now.
[[nodiscard]] Outcome<Done> remove_compressed(const std::filesystem::path& file);

/// All files of the site in this folder, those in its store too. R2W0210, R2W0211.
[[nodiscard]] Outcome<Done> precompress_site(const std::filesystem::path& folder,
                                             const Cancellation& cancellation);

/// The ending of the first compressed form beside `file` that does not unpack to these bytes.
/// `is_taken` reports whether the site itself has a file with that ending.
[[nodiscard]] std::optional<std::string> wrong_compressed(
    const std::filesystem::path& file, std::uint64_t size, const std::string& sha256,
    const std::function<bool(std::string_view ending)>& is_taken);

}  // namespace ros2wasm
