// The content-addressed store of unpacked packages: verified, atomic, safe for many processes at
// once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bundler/archive/package_reader.hpp"
#include "bundler/channel/channel_index.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// The fault of an unpacked package: the first file that differs from its info/paths.json, or an
/// changed info/. Empty for a package without a fault.
[[nodiscard]] std::string package_fault(const std::filesystem::path& folder);

/// The file beside an unpacked package with the hashes of the files in info/, which no list of the
/// package has.
[[nodiscard]] std::filesystem::path package_seal_place(const std::filesystem::path& folder);

struct StoredArchive {
  std::filesystem::path file;
  std::uint64_t size = 0;
};

class Store {
 public:
  /// `roots.cache` is made when first needed.
  explicit Store(ChannelRoots roots, ExtractLimits limits = {});

  /// The directories with the packages' files and their info/ (read-only; never write there), in
  /// the order of `records`. What is cached is checked file by file; the rest is downloaded and
  /// unpacked, many at once, each archive's sha256 and every file's being checked. R2W0220 wrong
  /// sha256 or size, R2W0221..R2W0226 see package_reader.hpp, R2W0228 an archive is not there,
  /// R2W0232..R2W0236 the network.
  [[nodiscard]] Outcome<std::vector<std::filesystem::path>> unpacked_all(
      const std::vector<PackageRecord>& records, const Cancellation& cancellation = {},
      const ProgressSink& progress = {}) const;

  /// One of them.
  [[nodiscard]] Outcome<std::filesystem::path> unpacked(
      const PackageRecord& record, const Cancellation& cancellation = {}) const;

  /// The archives themselves, in the order of `records`: those of channels on this machine where
  /// they are, the others in the cache, downloaded when they are not there. Size and hash are
  /// checked. R2W0210, R2W0220, R2W0228, R2W0232..R2W0236.
  [[nodiscard]] Outcome<std::vector<StoredArchive>> archives(
      const std::vector<PackageRecord>& records, const Cancellation& cancellation = {}) const;

  /// Where the archive of a package from the network is kept after it was unpacked.
  [[nodiscard]] std::filesystem::path archive_place(const PackageRecord& record) const;

  /// Where a package lies once it is unpacked; empty when the record has no sha256.
  [[nodiscard]] std::filesystem::path package_place(const PackageRecord& record) const;

  [[nodiscard]] const ChannelRoots& roots() const { return roots_; }

 private:
  /// The directory when it is there and every file of it is right.
  [[nodiscard]] Outcome<std::optional<std::filesystem::path>> cached(
      const PackageRecord& record) const;
  /// From an archive whose bytes were checked.
  [[nodiscard]] Outcome<std::filesystem::path> unpack(const PackageRecord& record,
                                                      const std::filesystem::path& archive,
                                                      const Cancellation& cancellation) const;
  /// The archive in a channel on this machine, checked.
  [[nodiscard]] Outcome<std::filesystem::path> local_archive(
      const PackageRecord& record, const Cancellation& cancellation) const;
  /// From a channel on this machine.
  [[nodiscard]] Outcome<std::filesystem::path> unpack_local(const PackageRecord& record,
                                                            const Cancellation& cancellation) const;

  ChannelRoots roots_;
  ExtractLimits limits_;
};

}  // namespace ros2wasm
