// The facts that were read from the archives of a channel's folder when its index was written, so
// that the next run reads only changed archives. An edge: asks the clock, reads and writes one file
// in that folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "bundler/io/mapped_file.hpp"
#include "bundler/io/sha256.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct KnownArchive {
  FileIdentity identity;
  FileHashes hashes;
  std::string index_json;  ///< the text of info/index.json
};

class KnownArchives {
 public:
  KnownArchives();  ///< none; the run begins

  /// Those of a folder. None where the file is absent, damaged or by another version of this
  /// program.
  [[nodiscard]] static KnownArchives of(const std::filesystem::path& folder);

  /// The archive as it is now: what is known when size, time and inode are those that they were, or
  /// else its sha256 is; read otherwise. A file that is not clearly older than the run that read it
  /// counts as changed: it may have been written to since, within one tick of the clock. R2W0210,
  /// R2W0221.
  [[nodiscard]] Outcome<KnownArchive> look_at(const std::filesystem::path& archive);

  /// How many look_at() had to read.
  [[nodiscard]] std::size_t read_count() const { return read_; }

  /// Keeps those which were looked at. R2W0210.
  [[nodiscard]] Outcome<Done> keep(const std::filesystem::path& folder) const;

 private:
  using Archives = std::map<std::string, KnownArchive>;  ///< by file name

  Archives before_;
  std::int64_t began_before_ns_ = 0;  ///< when the run that kept `before_` began to look
  Archives now_;
  std::int64_t began_ns_;
  std::size_t read_ = 0;
};

}  // namespace ros2wasm
