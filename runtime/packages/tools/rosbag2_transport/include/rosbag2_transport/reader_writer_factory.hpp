// Readers and writers for bags, whatever their form.
#pragma once

#include <memory>

#include "rosbag2_cpp/reader.hpp"
#include "rosbag2_cpp/writer.hpp"
#include "rosbag2_storage/storage_options.hpp"

namespace rosbag2_transport {

class ReaderWriterFactory {
 public:
  /// It is not open. There is one form: bags that are compressed as a whole are refused when they
  /// are opened.
  static std::unique_ptr<rosbag2_cpp::Reader> make_reader(const rosbag2_storage::StorageOptions&) {
    return std::make_unique<rosbag2_cpp::Reader>();
  }
};

}  // namespace rosbag2_transport
