// Steps 3 to 6 of a pack: the packages of channels are fetched, those of the workspace are built.
// Runs the compiler, and reads and writes the cache.
#pragma once

#include "bundler/pack_inputs.hpp"
#include "bundler/pack_values.hpp"
#include "bundler/request.hpp"
#include "bundler/store/environment.hpp"
#include "workspace_schema/base/progress_event.hpp"

namespace ros2wasm {

/// The end of step 3: what the lock says, in one prefix. R2W0534 for packages of another ABI; no
/// script of a package is run.
[[nodiscard]] Outcome<FetchedPackages> fetch_packages(const PackRequest& request,
                                                      const Question& question, const Store& store,
                                                      PackNotes& notes,
                                                      const Cancellation& cancellation,
                                                      const ProgressSink& progress);

/// Step 4: the packages of the workspace, or what building them would take.
[[nodiscard]] Outcome<BuiltPackages> build_packages(
    const PackRequest& request, const Question& question, const FetchedPackages& fetched,
    PackNotes& notes, const Cancellation& cancellation, const ProgressSink& progress);

/// Steps 5 and 6: programs with the plugins that they load; what is installed now.
[[nodiscard]] Outcome<Done> link_and_install(const Question& question,
                                             const FetchedPackages& fetched, bool for_channel,
                                             BuiltPackages& built, const Cancellation& cancellation,
                                             const ProgressSink& progress);

}  // namespace ros2wasm
