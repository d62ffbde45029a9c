// Formats of rcutils' logging.h mean what they mean on a 64-bit machine, for C++: see
// ros2wasm/lp64_format.hpp. That header ends with this one.
#ifndef RCUTILS__LP64_LOGGING_HPP_
#define RCUTILS__LP64_LOGGING_HPP_

#include <stdio.h>

#ifdef ROS2WASM_LP64_FORMAT_HPP_
extern "C" {
/// As rcutils_log(); as rcutils_log_internal() where it is known that the logger takes it.
void rcutils_lp64_log(const rcutils_log_location_t* location, int severity, const char* name,
                      bool is_known_to_be_taken, const char* format,
                      const ros2wasm::lp64::Slot* slots, int count);
}

extern "C++" {
template <typename... A>
inline ros2wasm::lp64::If<void, A...> rcutils_log(const rcutils_log_location_t* location,
                                                  int severity, const char* name,
                                                  const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  rcutils_lp64_log(location, severity, name, false, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<void, A...> rcutils_log_internal(const rcutils_log_location_t* location,
                                                           int severity, const char* name,
                                                           const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  rcutils_lp64_log(location, severity, name, true, format, slots, sizeof...(A));
}
}
#endif
#endif
