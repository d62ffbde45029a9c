// The forms of messages that there are.
#pragma once

#include <stdexcept>
#include <string>

namespace rosbag2_cpp {

/// Throws std::runtime_error for a form other than "cdr", as there is nothing that converts.
inline void need_converter(const std::string& format) {
  if (format != "cdr") {
    throw std::runtime_error("Could not find converter for format " + format);
  }
}

}  // namespace rosbag2_cpp
