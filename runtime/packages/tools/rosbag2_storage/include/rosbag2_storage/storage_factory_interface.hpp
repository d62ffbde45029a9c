// Opens storages.
#pragma once

#include <memory>

#include "rosbag2_storage/storage_interfaces/read_only_interface.hpp"
#include "rosbag2_storage/storage_interfaces/read_write_interface.hpp"

namespace rosbag2_storage {

class StorageFactoryInterface {
 public:
  virtual ~StorageFactoryInterface() = default;
  /// Null, with the reason in the log: it cannot be opened.
  virtual std::shared_ptr<storage_interfaces::ReadOnlyInterface> open_read_only(
      const StorageOptions& storage_options) = 0;
  virtual std::shared_ptr<storage_interfaces::ReadWriteInterface> open_read_write(
      const StorageOptions& storage_options) = 0;
};

}  // namespace rosbag2_storage
