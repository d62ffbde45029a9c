// Formats of rcutils' snprintf.h mean what they mean on a 64-bit machine, for C++: see
// ros2wasm/lp64_format.hpp. That header ends with this one.
#ifndef RCUTILS__LP64_SNPRINTF_HPP_
#define RCUTILS__LP64_SNPRINTF_HPP_

#include <stdio.h>

#ifdef ROS2WASM_LP64_FORMAT_HPP_
extern "C++" {
template <typename... A>
inline ros2wasm::lp64::If<int, A...> rcutils_snprintf(char* buffer, size_t buffer_size,
                                                      const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_snprintf(buffer, buffer_size, format, slots, sizeof...(A));
}
}
#endif
#endif
