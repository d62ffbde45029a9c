// The entries of `checks:` in a manifest.
#pragma once

#include <optional>

#include "workspace_schema/schema/manifest.hpp"
#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// Where an entry stands: a student takes the time a task needs, so `within` has no place there.
enum class CheckPlace { kList, kTask };

/// One entry; nothing when it has mistakes, which are reported. R2W0116 for a regular expression,
/// R2W0117 for keys that do not go together.
[[nodiscard]] std::optional<CheckEntry> read_check(Binder& binder, const YamlNode& node,
                                                   CheckPlace place = CheckPlace::kList);

}  // namespace ros2wasm
