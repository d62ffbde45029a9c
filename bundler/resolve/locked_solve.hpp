// Solving with a lock file: what is locked stays as long as it fits. Reads the lock; writing it is
// the caller's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/resolve/solve.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {

inline constexpr const char* kLockFileName = "ros2wasm.lock";

/// The packages that are chosen again although the lock has them.
struct LockUpdate {
  bool everything = false;
  std::vector<std::string> names;
};

/// R2W0331, with the nearest name that is among them.
[[nodiscard]] Diagnostic not_in_lock(const std::string& name,
                                     const std::vector<PackageRecord>& packages);

/// R2W0311: wheels that are others than those of a lock.
[[nodiscard]] Diagnostics other_wheels(const std::vector<LockedWheel>& locked,
                                       const std::vector<LockedWheel>& wanted);

/// R2W0311: libraries that are others than those of a lock.
[[nodiscard]] Diagnostics other_libraries(const std::vector<LockedLibrary>& locked,
                                          const std::vector<LockedLibrary>& wanted);

/// R2W0330 there is none, R2W0310 it is damaged, R2W0210.
[[nodiscard]] Outcome<Lock> read_lock_file(const std::filesystem::path& file);

/// The contents of a lock besides the packages.
struct LockRest {
  std::vector<std::string> absent;  ///< as in Lock
  std::vector<LockedSource> sources;
  std::vector<LockedWheel> wheels;
  std::string python_index;  ///< as in Lock
  std::vector<LockedLibrary> libraries;
};

struct LockedSolution {
  std::vector<PackageRecord> packages;  ///< in install order
  std::string lock_text;                ///< the lock that says so
  bool lock_changed = false;            ///< the file does not say so yet
};

/// `rest` goes into the lock as it is. `must_fit`: the lock has to hold as it is. R2W0320 it is
/// missing or does not fit; R2W0310 it is damaged; R2W0331 a package to choose anew is neither in
/// the lock nor needed; errors of solve(). Locked records that their channel no longer has are
/// chosen anew, unless `must_fit`.
[[nodiscard]] Outcome<LockedSolution> solve_with_lock(const std::vector<RequestedSpec>& specs,
                                                      const LockRest& rest, const RepoIndex& index,
                                                      const std::filesystem::path& lock_file,
                                                      ChannelPriority priority, bool must_fit,
                                                      const LockUpdate& update = {},
                                                      const Cancellation& cancellation = {});

}  // namespace ros2wasm
