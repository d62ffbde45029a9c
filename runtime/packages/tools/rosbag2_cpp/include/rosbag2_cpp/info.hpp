// Reads the metadata of a bag.
#pragma once

#include <string>

#include "rosbag2_storage/bag_metadata.hpp"

namespace rosbag2_cpp {

class Info {
 public:
  virtual ~Info() = default;
  /// `uri`: a folder or a file. Throws std::runtime_error.
  virtual rosbag2_storage::BagMetadata read_metadata(const std::string& uri,
                                                     const std::string& storage_id = "");
};

}  // namespace rosbag2_cpp
