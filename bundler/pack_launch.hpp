// Step 7 of a pack: what runs.
#pragma once

#include "bundler/launch_from_file.hpp"
#include "bundler/pack_values.hpp"
#include "bundler/request.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

/// The nodes of the launch file or of the manifest, or every program of the workspace; with the
/// programs of containers linked, and those that the manifest lists beside. R2W0406 when there is
/// none.
[[nodiscard]] Outcome<LaunchedFile> launch(const PackRequest& request,
                                           const BuiltWorkspace& workspace, PackNotes& notes,
                                           const Cancellation& cancellation,
                                           const ProgressSink& progress);

}  // namespace ros2wasm
