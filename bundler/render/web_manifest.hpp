// The file that browsers need to install a site as an app: the runtime's app.webmanifest with the
// site's title.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

[[nodiscard]] std::string web_manifest(std::string_view manifest, std::string_view title);

}  // namespace ros2wasm
