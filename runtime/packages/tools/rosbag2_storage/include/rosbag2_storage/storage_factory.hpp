// Opens bag files of MCAP. Other storages are refused: std::runtime_error says what can be done.
#pragma once

#include <memory>

#include "rosbag2_storage/storage_factory_interface.hpp"

namespace rosbag2_storage {

class StorageFactory : public StorageFactoryInterface {
 public:
  std::shared_ptr<storage_interfaces::ReadOnlyInterface> open_read_only(
      const StorageOptions& storage_options) override;
  std::shared_ptr<storage_interfaces::ReadWriteInterface> open_read_write(
      const StorageOptions& storage_options) override;
};

}  // namespace rosbag2_storage
