// The Content-Security-Policy of sites, as a header. It is that of runtime/site/ui/index.html,
// which the build reads.
#pragma once

#include <string_view>

namespace ros2wasm {

[[nodiscard]] std::string_view site_policy();

}  // namespace ros2wasm
