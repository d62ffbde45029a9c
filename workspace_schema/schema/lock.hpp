// ros2wasm.lock: the chosen packages, complete and sorted, as YAML with one form for one content.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// A wheel that the manifest names.
struct LockedWheel {
  std::string project;  ///< normal_project_name()
  std::string version;
  std::string file;  ///< relative to the manifest; empty: from `url`
  std::string url;
  std::string sha256;
  std::uint64_t size = 0;

  bool operator==(const LockedWheel&) const = default;
};

/// A library of Pyodide's distribution. Its address is that of `python_index` and its file.
struct LockedLibrary {
  std::string project;  ///< normal_project_name()
  std::string version;
  std::string file;  ///< its name: a wheel, or a .zip of libraries that wheels need
  std::string sha256;
  std::vector<std::string> depends;  ///< projects, sorted; some may come from elsewhere

  bool operator==(const LockedLibrary&) const = default;
};

/// A git repository or an archive that the manifest or a .repos file names.
struct LockedSource {
  std::string git;       ///< its address, or a path relative to the manifest; empty: an archive
  std::string revision;  ///< that was asked for; empty: the default branch
  std::string commit;    ///< that it was
  std::string tree;      ///< git's hash of the commit's files
  std::string archive;   ///< its address, or a path relative to the manifest
  std::string sha256;
  std::uint64_t size = 0;  ///< of a model's archive, in bytes; else 0
  std::string
      model;  ///< of Gazebo Fuel, "OpenRobotics/Coke Can", with "/2" for a version; else empty
  std::string package;  ///< the one that a distribution file led to it for; else empty
  std::vector<std::string>
      packages;  ///< that are taken of it, "arm_driver 0.3.0", sorted; for people

  bool operator==(const LockedSource&) const = default;
};

struct Lock {
  int schema = 1;
  std::string platform = "emscripten-wasm32";
  std::vector<std::string> channels;  ///< in the order of priority
  std::vector<std::string> specs;     ///< what was asked for, sorted; for people, never for a check
  /// The names that no channel had, sorted: packages that need one of these to be built are
  /// skipped.
  std::vector<std::string> absent;
  /// Packages of the workspace that packages of channels need, "ros-jazzy-arm-msgs 0.3.0", sorted.
  std::vector<std::string> built_here;
  std::vector<PackageRecord> packages;   ///< sorted by name
  std::vector<LockedSource> sources;     ///< sorted by place and revision
  std::vector<LockedWheel> wheels;       ///< sorted by project
  std::string python_index;              ///< where libraries come from; empty without any
  std::vector<LockedLibrary> libraries;  ///< sorted by project
};

/// The text of a lock; the same for the same content.
[[nodiscard]] std::string write_lock(const Lock& lock);

/// R2W0310: not a lock, with line and column. `file` is for messages.
[[nodiscard]] Outcome<Lock> read_lock(std::string_view text, const std::string& file);

}  // namespace ros2wasm
