// Reads and writes metadata.yaml.
#pragma once

#include <string>

#include "rosbag2_storage/bag_metadata.hpp"
#include "rosbag2_storage/visibility_control.hpp"

namespace rosbag2_storage {

class MetadataIo {
 public:
  static constexpr const char* const metadata_filename = "metadata.yaml";

  virtual ~MetadataIo() = default;
  /// `uri`: the bag's folder.
  virtual void write_metadata(const std::string& uri, const BagMetadata& metadata);
  /// Throws std::runtime_error for what is not such a file.
  virtual BagMetadata read_metadata(const std::string& uri);
  virtual bool metadata_file_exists(const std::string& uri);
  virtual std::string serialize_metadata(const BagMetadata& metadata);
  virtual BagMetadata deserialize_metadata(const std::string& serialized_metadata);
};

}  // namespace rosbag2_storage
