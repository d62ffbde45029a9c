// Interface to the metadata of a storage.
#pragma once

#include <cstdint>
#include <string>

#include "rosbag2_storage/bag_metadata.hpp"

namespace rosbag2_storage {
namespace storage_interfaces {

class BaseInfoInterface {
 public:
  virtual ~BaseInfoInterface() = default;
  virtual BagMetadata get_metadata() = 0;
  virtual std::string get_relative_file_path() const = 0;
  virtual uint64_t get_bagfile_size() const = 0;
  virtual std::string get_storage_identifier() const = 0;
};

}  // namespace storage_interfaces
}  // namespace rosbag2_storage
