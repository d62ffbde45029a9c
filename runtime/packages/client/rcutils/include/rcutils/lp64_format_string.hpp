// Formats of rcutils' format_string.h mean what they mean on a 64-bit machine, for C++: see
// ros2wasm/lp64_format.hpp. That header ends with this one.
#ifndef RCUTILS__LP64_FORMAT_STRING_HPP_
#define RCUTILS__LP64_FORMAT_STRING_HPP_

#include <stdio.h>

#ifdef ROS2WASM_LP64_FORMAT_HPP_
extern "C" {
char* rcutils_lp64_format_string(rcutils_allocator_t allocator, size_t limit, const char* format,
                                 const ros2wasm::lp64::Slot* slots, int count);
}

extern "C++" {
template <typename... A>
inline ros2wasm::lp64::If<char*, A...> rcutils_format_string_limit(rcutils_allocator_t allocator,
                                                                   size_t limit, const char* format,
                                                                   A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return rcutils_lp64_format_string(allocator, limit, format, slots, sizeof...(A));
}
}
#endif
#endif
