// The forms of messages before and after a bag. There is one, "cdr"; nothing is converted.
#pragma once

#include <string>

namespace rosbag2_cpp {

struct ConverterOptions {
  std::string input_serialization_format;
  std::string output_serialization_format;
};

}  // namespace rosbag2_cpp
