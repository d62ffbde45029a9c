// The files of a site in a folder, by their paths in site.json. An edge: reads files.
#pragma once

#include <filesystem>
#include <string>

#include "bundler/site/site_list.hpp"
#include "bundler/verify/site_diff.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct OpenSite {
  std::filesystem::path folder;
  std::string text;  ///< site.json
  SiteList list;
};

/// R2W0210, R2W0605, R2W0608.
[[nodiscard]] Outcome<OpenSite> open_site(const std::filesystem::path& folder);

/// The whole file, joined where it lies in parts. Read by its real path: what a site calls its own
/// may be a link out of it, or out of the store. R2W0210.
[[nodiscard]] Outcome<std::string> site_bytes(const OpenSite& site, const std::string& path);

/// For site_differences(); must not outlive `site`.
[[nodiscard]] ComparedSite compared(const OpenSite& site);

}  // namespace ros2wasm
