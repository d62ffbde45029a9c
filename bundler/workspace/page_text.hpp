// The Markdown file of the page's text panel (`ui: text:`) and the images it names, which become
// files of the site.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/plan/site_plan.hpp"

namespace ros2wasm {

/// The paths of inline images, `![words](path)` or `![words](path "title")`, in order, without
/// repetition: percent-decoded, without `?...` and `#...`. Not those in code, and no addresses
/// (`https:`, `//host`, `/root`). Pure.
[[nodiscard]] std::vector<std::string> markdown_images(std::string_view markdown);

/// The file and its images. R2W0118: one of them is not within `folder`, is not there, is no image,
/// or all are too large. An edge: reads files.
[[nodiscard]] Outcome<std::vector<PageFile>> read_page_text(const std::filesystem::path& folder,
                                                            const Spanned<std::string>& file);

}  // namespace ros2wasm
