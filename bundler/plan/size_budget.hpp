// The sizes of the parts of a site, and whether they are within the budget of the manifest. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "bundler/plan/plan_site.hpp"

namespace ros2wasm {

/// Bytes by part of a site: `package demo`, `runtime`, `pyodide`, `python`, `text`, `bags`,
/// `lists`.
using PartSizes = std::map<std::string, std::uint64_t>;

/// The sizes of all files, without those with names of functions, which no visit loads, and without
/// the channel beside the site.
[[nodiscard]] PartSizes part_sizes(const SitePlan& plan);

/// The bytes that a server with gzip sends for the same files, each once.
[[nodiscard]] std::uint64_t compressed_size(const SitePlan& plan);

/// The text of `ros2wasm.sizes`: a line for each part, in order.
[[nodiscard]] std::string sizes_text(const PartSizes& sizes);

/// Reads such a text. Other lines, such as conflict marks of a merge, are skipped.
[[nodiscard]] PartSizes read_sizes(std::string_view text);

/// R2W0660 with what grew since `before`, and without it with what is largest.
[[nodiscard]] std::optional<Diagnostic> over_budget(const SiteBudget& budget, const SitePlan& plan,
                                                    const std::optional<PartSizes>& before);

}  // namespace ros2wasm
