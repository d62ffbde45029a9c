// How a bag is written or read.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include "rosbag2_storage/visibility_control.hpp"

namespace rosbag2_storage {

struct StorageOptions {
  std::string uri;
  /// Empty: "mcap".
  std::string storage_id;
  /// Bytes after which the next file begins; 0: one file.
  uint64_t max_bagfile_size = 0;
  /// Seconds, as well.
  uint64_t max_bagfile_duration = 0;
  /// Bytes that a snapshot has; messages go to the file at once whatever it says.
  uint64_t max_cache_size = 0;
  /// "none", or "fastwrite": without chunks and index. Others need zstd, and are refused.
  std::string storage_preset_profile = "";
  /// A YAML file with `noChunking`, `chunkSize`, `compression`.
  std::string storage_config_uri = "";
  /// Messages are kept in memory, and written by take_snapshot().
  bool snapshot_mode = false;
  /// ns since 1970; messages before and after are not written. Negative: no limit.
  int64_t start_time_ns = -1;
  int64_t end_time_ns = -1;
  std::unordered_map<std::string, std::string> custom_data{};
};

}  // namespace rosbag2_storage
