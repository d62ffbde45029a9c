// The storage of bags that name none.
#pragma once

#include <string>

namespace rosbag2_storage {

/// "mcap", the only one.
std::string get_default_storage_id();

}  // namespace rosbag2_storage
