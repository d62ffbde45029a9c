// Whether the bytes of a site are those that its site.json names: in a folder, in one page, or
// below an address.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/channel/channel_network.hpp"
#include "bundler/site/site_list.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

struct SiteCheck {
  SiteList list;
  Diagnostics faults;  ///< R2W0650 other bytes, R2W0651 not there; as site.json has them
  std::vector<std::string> unlisted;  ///< that lie in the folder too, sorted
  std::string site_json;
  std::optional<std::string> signature;  ///< the text beside it, where there is one
};

/// R2W0653, a warning: the folder `shown` has these files, which its site.json does not list. The
/// first ones are named.
[[nodiscard]] Diagnostic unlisted_files(const std::vector<std::string>& paths,
                                        const std::string& shown);

/// Reads every file. Links are not followed: a site has none. R2W0210, R2W0605, R2W0608.
[[nodiscard]] Outcome<SiteCheck> check_site_folder(const std::filesystem::path& folder,
                                                   const Cancellation& cancellation,
                                                   const ProgressSink& progress);

/// Checks every file that is embedded in a page of `pack -o NAME.html`. Also R2W0202.
[[nodiscard]] Outcome<SiteCheck> check_site_page(const std::filesystem::path& file,
                                                 const Cancellation& cancellation,
                                                 const ProgressSink& progress);

/// Brings every file, as a visit would. `url` is that of the page, of its folder or of site.json.
/// The signature is asked for with `signature` only. Also R2W0233 to R2W0236.
[[nodiscard]] Outcome<SiteCheck> check_site_address(const std::string& url,
                                                    const ChannelNetwork& network, bool signature,
                                                    const Cancellation& cancellation,
                                                    const ProgressSink& progress);

}  // namespace ros2wasm
