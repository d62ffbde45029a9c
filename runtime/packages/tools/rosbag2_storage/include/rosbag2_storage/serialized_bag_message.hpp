// A message of a bag, as its bytes. Times are ns since 1970.
#pragma once

#include <memory>
#include <string>

#include "rcutils/time.h"
#include "rcutils/types/uint8_array.h"

namespace rosbag2_storage {

struct SerializedBagMessage {
  std::shared_ptr<rcutils_uint8_array_t> serialized_data;
  rcutils_time_point_value_t recv_timestamp = 0;
  /// When it was published; `recv_timestamp` where nobody knows.
  rcutils_time_point_value_t send_timestamp = 0;
  std::string topic_name;
};

using SerializedBagMessageSharedPtr = std::shared_ptr<SerializedBagMessage>;
using SerializedBagMessageConstSharedPtr = std::shared_ptr<const SerializedBagMessage>;

}  // namespace rosbag2_storage
