// The type of a file of a site, by its name.
#pragma once

#include <string_view>

namespace ros2wasm {

/// The Content-Type of a file; `application/octet-stream` when its ending is not known.
[[nodiscard]] std::string_view mime_type(std::string_view file_name);

}  // namespace ros2wasm
