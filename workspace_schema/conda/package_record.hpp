// One package as a channel's index and the lock describe it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ros2wasm {

enum class NoarchKind { kNo, kGeneric, kPython };

struct PackageRecord {
  std::string name;     ///< lower case
  std::string version;  ///< as written by the channel
  std::string build;
  std::uint64_t build_number = 0;
  std::string subdir;     ///< "emscripten-wasm32" or "noarch"
  std::string channel;    ///< as the request names it: "embedded", "./dir", "https://host/name"
  std::string file_name;  ///< "name-version-build.conda" or ".tar.bz2"
  std::string
      url;  ///< where the archive is: <channel>/<subdir>/<file>; "embedded:/<subdir>/<file>"
  std::string sha256;      ///< of the archive, lower-case hex; empty when the channel does not say
  std::string md5;         ///< likewise
  std::uint64_t size = 0;  ///< of the archive in bytes; 0 when the channel does not say
  std::vector<std::string> depends;     ///< match specs, as written
  std::vector<std::string> constrains;  ///< match specs that hold only if the package is there
  std::vector<std::string> track_features;
  std::string license;
  std::int64_t timestamp_ms = 0;  ///< of the build, since 1970; 0 when unknown
  NoarchKind noarch = NoarchKind::kNo;

  bool operator==(const PackageRecord&) const = default;
};

/// "name-version-build", as conda names a distribution.
[[nodiscard]] inline std::string distribution_name(const PackageRecord& record) {
  return record.name + "-" + record.version + "-" + record.build;
}

}  // namespace ros2wasm
