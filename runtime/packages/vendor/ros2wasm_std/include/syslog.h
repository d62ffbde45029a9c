// C's header, and for C++ the overload by which formats mean what they mean on a 64-bit machine
// (ros2wasm/lp64_format.hpp).
#include_next <syslog.h>
#ifndef __cplusplus
void syslog(int, const char*, ...) __attribute__((format(printf, 2, 3)));
#endif
#if !defined(ROS2WASM_SYSLOG_H_) && defined(__cplusplus) && __cplusplus >= 201103L
#define ROS2WASM_SYSLOG_H_
#include "ros2wasm/lp64_format.hpp"

extern "C" void ros2wasm_lp64_syslog(int priority, const char* format,
                                     const ros2wasm::lp64::Slot* slots, int count);

extern "C++" {
template <typename... A>
inline ros2wasm::lp64::If<void, A...> syslog(int priority, const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  ros2wasm_lp64_syslog(priority, format, slots, sizeof...(A));
}
}
#endif
