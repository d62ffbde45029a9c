// Log macros with a format that is a std::string, which ROS 2 up to Foxy took.
#pragma once

#include <string>
#include <type_traits>

#include "rcutils/logging.h"

/// Literals, which compilers check, go to that of rcutils.
template <typename Format, typename... Values,
          std::enable_if_t<std::is_same_v<Format, std::string>, int> = 0>
void rcutils_log_internal(const rcutils_log_location_t* location, int severity, const char* name,
                          const Format& format, Values... values) {
  const char* text = format.c_str();
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wformat-security"
#pragma clang diagnostic ignored "-Wformat-nonliteral"
  rcutils_log_internal(location, severity, name, text, values...);
#pragma clang diagnostic pop
}
