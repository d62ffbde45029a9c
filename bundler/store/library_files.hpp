// The files of libraries of Pyodide's distribution, on this machine: from a folder, or over the
// network through the cache, whose hashes are checked. An edge: disk and network.
#pragma once

#include <string>
#include <vector>

#include "bundler/archive/wheel_reader.hpp"
#include "bundler/channel/channel_index.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {

/// One of both: a wheel, or libraries that wheels need.
struct LibraryFiles {
  LockedLibrary locked;
  Wheel wheel;
  SharedLibraries shared;
};

/// `index`: an address, or a folder relative to the manifest. In the order of `libraries`. R2W0246,
/// once for all that cannot be had; R2W0220 another file than the lock says; those of read_wheel()
/// and read_shared_libraries().
[[nodiscard]] Outcome<std::vector<LibraryFiles>> read_libraries(
    const std::vector<LockedLibrary>& libraries, const std::string& index,
    const ChannelRoots& roots, const ExtractLimits& limits, const Cancellation& cancellation);

/// Brings all of them into the cache. Errors as above.
[[nodiscard]] Outcome<Done> fetch_libraries(const std::vector<LockedLibrary>& libraries,
                                            const std::string& index, const ChannelRoots& roots,
                                            const Cancellation& cancellation);

}  // namespace ros2wasm
