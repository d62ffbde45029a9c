// `ui: layout:`, how the author wants the panels of the page to stand: checked, and as JSON for
// site.json. The page's own reader is runtime/site/ui/model/layout_text.ts. Pure.
#pragma once

#include <string>

#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// One line of JSON; empty when something was reported. R2W0103 what is not a layout, R2W0102 an
/// unknown panel or key.
[[nodiscard]] std::string read_page_layout(Binder& binder, const YamlNode& node);

}  // namespace ros2wasm
