// The first steps of a pack: the manifest, the packages of the workspace, what the channels have
// and which of it is wanted. Reads the disk, and the network through channels.
#pragma once

#include <string>
#include <vector>

#include "bundler/build/compiler.hpp"
#include "bundler/channel/channel_index.hpp"
#include "bundler/pack_values.hpp"
#include "bundler/request.hpp"
#include "bundler/resolve/locked_solve.hpp"
#include "bundler/workspace/build_order.hpp"
#include "bundler/workspace/skipped_packages.hpp"

namespace ros2wasm {

/// The inputs that are known before dependencies are resolved.
struct Question {
  ReadWorkspace read;
  Supplies supplies;
  std::vector<LocalPackage> packages;
  BuildOrder order;
  LeftOutPackages left_out;
  Lacks lacks;                      ///< of packages that are built all the same
  std::vector<std::string> absent;  ///< what was looked for in vain
  Compiler compiler;
  RepoIndex index;                        ///< what the channels have
  std::vector<std::string> all_packages;  ///< ROS names of all of it, sorted
  std::vector<RequestedSpec> specs;       ///< what is asked of them
};

/// Whether a build of the package runs its setup.py.
[[nodiscard]] bool reads_setup_py(const LocalPackage& package);

/// Steps 1 to 3, up to the request to the channels, which a frozen lock fulfils (R2W0311).
[[nodiscard]] Outcome<Question> ask(const PackRequest& request, PackNotes& notes,
                                    const Cancellation& cancellation, const ProgressSink& progress);

/// The parts of ros2wasm.lock that are not packages of channels.
[[nodiscard]] LockRest lock_rest(const Question& question);

/// The records that the workspace needs, and the text of its lock.
struct Resolved {
  std::vector<PackageRecord> records;
  std::string lock_text;
};

/// The next part of step 3: the records as the lock has them, or chosen anew.
[[nodiscard]] Outcome<Resolved> resolve(const PackRequest& request, const Question& question,
                                        PackNotes& notes, const Cancellation& cancellation);

}  // namespace ros2wasm
