// What a bag says of itself.
#pragma once

#include <string>

#include "rosbag2_storage/bag_metadata.hpp"

namespace rosbag2_cpp {

class Info {
 public:
  virtual ~Info() = default;
  /// Of a folder or a file. Throws std::runtime_error.
  virtual rosbag2_storage::BagMetadata read_metadata(const std::string& uri,
                                                     const std::string& storage_id = "");
};

}  // namespace rosbag2_cpp
