// The page of one site: the runtime's index.html with the site's title and with hints to fetch its
// programs early. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// `page` without a <title> or </head> stays as it is there. Texts are escaped; `programs` are
/// paths in the site, each named once.
[[nodiscard]] std::string page_html(std::string page, std::string_view title,
                                    const std::vector<std::string>& programs);

}  // namespace ros2wasm
