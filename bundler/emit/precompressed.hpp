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

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Writes both where they are smaller, and removes those that are not of these bytes; leaves what
/// is `taken`, the site's own files. R2W0210, R2W0211.
[[nodiscard]] Outcome<Done> precompress_file(const std::filesystem::path& file,
                                             const std::set<std::filesystem::path>& taken = {});

/// Removes the compressed forms of a file whose bytes have changed.
[[nodiscard]] Outcome<Done> remove_compressed(const std::filesystem::path& file);

/// All files of the site in this folder, those in its store too. R2W0210, R2W0211.
[[nodiscard]] Outcome<Done> precompress_site(const std::filesystem::path& folder,
                                             const Cancellation& cancellation);

}  // namespace ros2wasm
