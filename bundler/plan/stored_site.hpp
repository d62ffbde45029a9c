// What becomes of a planned site that shares a store with others, or has a ceiling for its files.
// Pure.
#pragma once

#include <string>

#include "bundler/plan/site_plan.hpp"

namespace ros2wasm {

/// What does not have to lie in the site's own folder, when there is a store.
void keep_in_store(SitePlan& plan);

/// Files above the ceiling lie in parts. R2W0617 for one that a browser loads by itself, as a
/// whole.
[[nodiscard]] Diagnostics split_files(SitePlan& plan, std::uint64_t most_bytes);

/// Elements of the page find the files where they lie. To be called once.
void place_page(SitePlan& plan);

/// The names of the parts' owners come first, the texts, which many sites have, after them.
void share_texts(PlannedFile& licenses);

}  // namespace ros2wasm
