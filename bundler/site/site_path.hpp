// Which paths a file of a site may have. Pure.
#pragma once

#include <optional>
#include <string>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// R2W0608 unless a file of this path lies in the site's folder.
[[nodiscard]] std::optional<Diagnostic> refuse_site_path(const std::string& path);

}  // namespace ros2wasm
