// A storage that is read.
#pragma once

#include "rcutils/time.h"
#include "rosbag2_storage/storage_filter.hpp"
#include "rosbag2_storage/storage_interfaces/base_info_interface.hpp"
#include "rosbag2_storage/storage_interfaces/base_io_interface.hpp"
#include "rosbag2_storage/storage_interfaces/base_read_interface.hpp"

namespace rosbag2_storage {
namespace storage_interfaces {

class ReadOnlyInterface : public BaseInfoInterface,
                          public BaseIOInterface,
                          public BaseReadInterface {
 public:
  void open(const StorageOptions& storage_options, IOFlag io_flag = IOFlag::READ_ONLY) override = 0;
  /// From the present place on.
  virtual void set_filter(const StorageFilter& storage_filter) = 0;
  virtual void reset_filter() = 0;
  /// The next message is the first one at that time or later; in reverse order or earlier.
  virtual void seek(const rcutils_time_point_value_t& timestamp) = 0;
};

}  // namespace storage_interfaces
}  // namespace rosbag2_storage
