// Changes to a planned site that shares a store with others, or has a size limit for its files.
// Pure.
#pragma once

#include <string>

#include "bundler/plan/plan_site.hpp"

namespace ros2wasm {

/// When there is a store, marks the files for it that need not be in the site's own folder.
void keep_in_store(SitePlan& plan);

/// Splits files above the limit into parts. R2W0617 for one that a browser loads by itself, as a
/// whole.
[[nodiscard]] Diagnostics split_files(SitePlan& plan, std::uint64_t most_bytes);

/// Puts the final places of the files into the elements of the page. To be called once.
void place_page(SitePlan& plan);

/// The names of the parts' owners come first, the texts, which many sites have, after them.
void share_texts(PlannedFile& licenses);

}  // namespace ros2wasm
