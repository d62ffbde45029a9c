// The lock of a workspace, for commands that only look at it.
#pragma once

#include <string>

#include "workspace_schema/base/json_writer.hpp"
#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {

/// ros2wasm.lock of a workspace's folder, or of the folder of its manifest; empty: the current
/// folder. R2W0330 there is none, R2W0310 it cannot be read.
[[nodiscard]] Outcome<Lock> read_workspace_lock(const std::string& workspace);

/// The source from which a package is built, by its ROS name; null when none is. Points into the
/// lock.
[[nodiscard]] const LockedSource* source_of_package(const Lock& lock, const std::string& package);

/// "https://example.org/arms 1.0, commit 0123456789", or the place of an archive.
[[nodiscard]] std::string title_of(const LockedSource& source);

/// A map with what the lock says of it.
void write_source(JsonWriter& json, const LockedSource& source);

}  // namespace ros2wasm
