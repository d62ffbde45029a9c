// The page of one site: the runtime's index.html with the site's title and theme, and with hints to
// fetch its programs early. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// `page` without a <title> or </head> stays as it is there. Texts are escaped; `programs` are
/// paths in the site, each named once. `theme` is that of the manifest: auto, light or dark.
[[nodiscard]] std::string page_html(std::string page, std::string_view title,
                                    std::string_view theme,
                                    const std::vector<std::string>& programs);

}  // namespace ros2wasm
