// Base interface of storages that can be opened.
#pragma once

#include <cstdint>

#include "rosbag2_storage/storage_options.hpp"

namespace rosbag2_storage {
namespace storage_interfaces {

enum class IOFlag : uint8_t { READ_ONLY = 0, READ_WRITE = 1, APPEND = 2 };

inline constexpr uint64_t MAX_BAGFILE_SIZE_NO_SPLIT = 0;
inline constexpr uint64_t MAX_BAGFILE_DURATION_NO_SPLIT = 0;

class BaseIOInterface {
 public:
  virtual ~BaseIOInterface() = default;
  virtual void open(const StorageOptions& storage_options, IOFlag io_flag) = 0;
};

}  // namespace storage_interfaces
}  // namespace rosbag2_storage
