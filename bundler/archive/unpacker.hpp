// Writes the members of an archive below a folder, safely: nothing is written outside of it, or
// through a link. Files are written as they come; links only when all files are there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bundler/archive/archive_library.hpp"
#include "bundler/archive/extract_limits.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct WrittenFile {
  std::string sha256;
  std::uint64_t size = 0;
};

/// An archive of which nothing is stored, and why.
[[nodiscard]] Diagnostic nothing_stored(DiagnosticCode code, const std::string& name,
                                        const std::string& why);

class Unpacker {
 public:
  /// All of them must live as long. `name` is for messages, `packed_bytes` the size of the archive.
  Unpacker(const std::filesystem::path& directory, const std::string& name,
           const ExtractLimits& limits, std::uint64_t packed_bytes,
           const Cancellation& cancellation);

  /// R2W0222 a name that leads outside, R2W0223 a link that does, R2W0224 two members with one name
  /// or names that differ in letter case only, R2W0225 over a limit.
  [[nodiscard]] Outcome<Done> member(const ArchiveMember& member, const ByteSource& bytes);
  /// When all members are there. Codes as above.
  [[nodiscard]] Outcome<Done> write_links();
  /// One more name for a file that is there.
  [[nodiscard]] Outcome<Done> add_name(const std::string& path, const std::string& file);

  [[nodiscard]] const std::map<std::string, WrittenFile>& files() const { return files_; }
  [[nodiscard]] const std::map<std::string, std::string>& links() const { return links_; }
  /// Links whose target the archive does not say: they are not written.
  [[nodiscard]] const std::vector<std::string>& empty_links() const { return empty_links_; }
  [[nodiscard]] std::uint64_t total_bytes() const { return meter_.total_bytes(); }

 private:
  [[nodiscard]] Outcome<Done> claim(const std::string& path);
  [[nodiscard]] Outcome<Done> make_folder(const std::string& path);
  [[nodiscard]] Outcome<Done> make_folder_of(const std::string& path);
  [[nodiscard]] Outcome<Done> file(const std::string& path, bool executable,
                                   const ByteSource& bytes);
  [[nodiscard]] Outcome<WrittenFile> copy(const ByteSource& bytes, int fd,
                                          const std::filesystem::path& place);
  [[nodiscard]] Outcome<Done> link(const std::string& path, const std::string& target);
  [[nodiscard]] Outcome<Done> hard_link(const std::string& path, const std::string& target);
  [[nodiscard]] Outcome<Done> write_hard_links();
  [[nodiscard]] Outcome<Done> write_symbolic_links();

  const std::filesystem::path& directory_;
  const std::string& name_;
  ExtractMeter meter_;
  const Cancellation& cancellation_;
  std::map<std::string, std::string> claimed_;  ///< lower case -> as it came
  std::map<std::string, WrittenFile> files_;
  std::map<std::string, std::string> links_;
  std::vector<std::string> empty_links_;
  std::vector<std::pair<std::string, std::string>> hard_links_;
};

}  // namespace ros2wasm
