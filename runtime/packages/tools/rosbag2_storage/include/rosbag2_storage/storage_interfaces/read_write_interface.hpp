// A storage that is written, or read.
#pragma once

#include "rosbag2_storage/storage_interfaces/base_write_interface.hpp"
#include "rosbag2_storage/storage_interfaces/read_only_interface.hpp"

namespace rosbag2_storage {
namespace storage_interfaces {

class ReadWriteInterface : public ReadOnlyInterface, public BaseWriteInterface {
 public:
  void open(const StorageOptions& storage_options,
            IOFlag io_flag = IOFlag::READ_WRITE) override = 0;
  /// Bytes; a bag is not split into smaller files.
  virtual uint64_t get_minimum_split_file_size() const = 0;
};

}  // namespace storage_interfaces
}  // namespace rosbag2_storage
