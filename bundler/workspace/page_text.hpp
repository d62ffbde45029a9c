// The Markdown file of the page's text panel (`ui: text:`) and the images it names, which become
// files of the site; and what other files of the page share with it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/site/site_file.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// The paths of inline images, `![words](path)` or `![words](path "title")`, in order, without
/// repetition: percent-decoded, without `?...` and `#...`. Not those in code, and no addresses
/// (`https:`, `//host`, `/root`). Pure.
[[nodiscard]] std::vector<std::string> markdown_images(std::string_view markdown);

/// A function that finds the images that a file of the page names, from its bytes.
using ImagesOf = std::function<Outcome<std::vector<std::string>>(const std::string& bytes)>;

/// The file, of at most `most` bytes, and the images that it names. R2W0118, as below. An edge:
/// reads files.
[[nodiscard]] Outcome<std::vector<PageFile>> read_with_images(const std::filesystem::path& folder,
                                                              const Spanned<std::string>& file,
                                                              std::size_t most,
                                                              const ImagesOf& images_of);

/// The file and its images. R2W0118: one of them is not within `folder`, is not there, is not an
/// image, or all are too large. An edge: reads files.
[[nodiscard]] Outcome<std::vector<PageFile>> read_page_text(const std::filesystem::path& folder,
                                                            const Spanned<std::string>& file);

/// The images that the texts of tasks name, relative to the manifest. R2W0118 as above. An edge:
/// reads files.
[[nodiscard]] Outcome<std::vector<PageFile>> read_task_images(const std::filesystem::path& folder,
                                                              const std::vector<TaskEntry>& tasks);

}  // namespace ros2wasm
