// Recordings that the page plays (`ui: bags:`), which become files of the site.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/site/site_file.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// R2W0118: one of them is not within `folder`, is not there, is not an MCAP, comes twice, or all
/// are too large. An edge: reads files.
[[nodiscard]] Outcome<std::vector<PageFile>> read_page_bags(
    const std::filesystem::path& folder, const std::vector<Spanned<std::string>>& bags);

/// R2W0118 as a warning for each that does not end as a whole MCAP file does: the page plays what
/// is there. `files`: those of read_page_bags(). Pure.
[[nodiscard]] Diagnostics cut_bags(const std::vector<PageFile>& files,
                                   const std::vector<Spanned<std::string>>& bags);

/// All files of the workspace that the manifest gives to the page.
struct PageFiles {
  std::vector<PageFile> text;
  std::vector<PageFile> bags;
};

/// The same, and what read_page_text() refuses. An edge: reads files.
[[nodiscard]] Outcome<PageFiles> read_page_files(const std::filesystem::path& folder,
                                                 const Manifest& manifest);

}  // namespace ros2wasm
