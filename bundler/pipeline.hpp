// The whole way from a workspace to a site, in one place: pipeline.cpp reads as its table of
// contents.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/pack_values.hpp"
#include "bundler/plan/plan_site.hpp"
#include "bundler/request.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

struct PackReport {
  SitePlan plan;
  std::filesystem::path output;
  PackNotes notes;
};

struct LockReport {
  std::filesystem::path file;
  std::vector<PackageRecord> packages;
  bool changed = false;
  Diagnostics warnings;
};

/// Writes ros2wasm.lock without building, or checks it by satisfiability (R2W0311, one per edge
/// that does not hold).
[[nodiscard]] Outcome<LockReport> lock(const LockRequest& request, const Cancellation& cancellation,
                                       const ProgressSink& progress);

/// Everything up to the installed packages.
[[nodiscard]] Outcome<BuiltWorkspace> build(const PackRequest& request,
                                            const Cancellation& cancellation,
                                            const ProgressSink& progress);

/// build(), then launch, plan, emit.
[[nodiscard]] Outcome<PackReport> pack(const PackRequest& request, const Cancellation& cancellation,
                                       const ProgressSink& progress);

}  // namespace ros2wasm
