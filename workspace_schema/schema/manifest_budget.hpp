// `site: budget:` of a manifest.
#pragma once

#include "workspace_schema/schema/manifest.hpp"
#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// A size for the whole site, or a mapping with `total` and `compressed`. R2W0103 for what is no
/// size.
[[nodiscard]] SiteBudget read_site_budget(Binder& binder, const YamlNode& node);

}  // namespace ros2wasm
