// A site as one HTML page, which carries all of its files: each deflated, in base64, in an element
// that browsers do not run. runtime/site/program/page_files.ts reads them there. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/render/site_plan.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// `plan.carried_page` with the plan's files in it, site.json first.
[[nodiscard]] std::string carried_page(const SitePlan& plan);

/// The line that says which site it is.
[[nodiscard]] std::string carried_page_mark(const std::string& generator, const std::string& hash);

/// A file as the page has it.
struct CarriedFile {
  std::string_view path;
  std::string_view text;  ///< base64 of what deflate made
};

struct CarriedPage {
  std::string bare;  ///< `plan.carried_page`
  std::string_view mark;
  std::vector<CarriedFile> files;  ///< at least site.json, which is the first
};

/// `page` may be anybody's; R2W0605 when it is not as carried_page() writes it. `shown` names it.
[[nodiscard]] Outcome<CarriedPage> read_carried_page(std::string_view page,
                                                     const std::string& shown);

/// R2W0202 damaged, or more than `limit_bytes`.
[[nodiscard]] Outcome<std::string> unpacked(const CarriedFile& file, std::uint64_t limit_bytes);

}  // namespace ros2wasm
