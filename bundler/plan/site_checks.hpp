// Which processes of the site the manifest's checks mean. Pure.
#pragma once

#include <vector>

#include "bundler/launch/launch_graph.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// The checks with the ids of nodes in place of what names them: an id, a full name or an
/// executable. R2W0430 for a name that no node or more than one has; all at once.
[[nodiscard]] Outcome<std::vector<CheckEntry>> site_checks(std::vector<CheckEntry> checks,
                                                           const std::vector<LaunchNode>& nodes);

}  // namespace ros2wasm
