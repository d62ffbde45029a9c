// The components of a site and their licenses, for people and for machines. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/site/site_component.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// LICENSES.txt: each component with its license, then each text once, with those that it is of.
[[nodiscard]] std::string license_list(const Manifest& manifest,
                                       const std::vector<SiteComponent>& components);

/// SPDX 2.3 in JSON. `content` is a hash of the site's other files, which makes the document's name
/// unique; the time of its making is that of no clock: the date of the citation, else 1970.
[[nodiscard]] std::string spdx_document(const Manifest& manifest,
                                        const std::vector<SiteComponent>& components,
                                        std::string_view content);

}  // namespace ros2wasm
