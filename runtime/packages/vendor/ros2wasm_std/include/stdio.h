// C's header, and for C++ the overloads by which formats mean what they mean on a 64-bit machine
// (ros2wasm/lp64_format.hpp). Under their own names, so that `printf`, `std::printf` and `::printf`
// all find them and a member of a class that is called so is nobody's; a call without further
// arguments is that of C's function. In C, which has no overloads, the compiler checks the formats
// of the functions that it does not know by itself; the toolchain makes its findings errors.
#include_next <stdio.h>
#if !defined(__cplusplus) && \
    (defined(_GNU_SOURCE) || defined(_BSD_SOURCE) || defined(_POSIX_C_SOURCE))
int dprintf(int, const char* restrict, ...) __attribute__((format(printf, 2, 3)));
#endif
#if !defined(__cplusplus) && (defined(_GNU_SOURCE) || defined(_BSD_SOURCE))
int asprintf(char**, const char*, ...) __attribute__((format(printf, 2, 3)));
#endif
#if !defined(ROS2WASM_STDIO_H_) && defined(__cplusplus) && __cplusplus >= 201103L && defined(EOF)
#define ROS2WASM_STDIO_H_
#include "ros2wasm/lp64_format.hpp"

extern "C" {
int ros2wasm_lp64_fprintf(FILE* stream, const char* format, const ros2wasm::lp64::Slot* slots,
                          int count);
int ros2wasm_lp64_snprintf(char* to, __SIZE_TYPE__ size, const char* format,
                           const ros2wasm::lp64::Slot* slots, int count);
int ros2wasm_lp64_asprintf(char** to, const char* format, const ros2wasm::lp64::Slot* slots,
                           int count);
int ros2wasm_lp64_dprintf(int to, const char* format, const ros2wasm::lp64::Slot* slots, int count);
int ros2wasm_lp64_fscanf(FILE* stream, const char* format, const ros2wasm::lp64::Slot* slots,
                         int count);
int ros2wasm_lp64_sscanf(const char* from, const char* format, const ros2wasm::lp64::Slot* slots,
                         int count);
}

extern "C++" {
template <typename... A>
inline ros2wasm::lp64::If<int, A...> printf(const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_fprintf(stdout, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<int, A...> fprintf(FILE* stream, const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_fprintf(stream, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<int, A...> sprintf(char* to, const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_snprintf(to, __INT_MAX__, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<int, A...> snprintf(char* to, __SIZE_TYPE__ size, const char* format,
                                              A... arguments) ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_snprintf(to, size, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<int, A...> asprintf(char** to, const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_asprintf(to, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<int, A...> dprintf(int to, const char* format, A... arguments)
    ROS2WASM_LP64_CHECKED(format) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_dprintf(to, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<int, A...> scanf(const char* format, A... arguments) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_fscanf(stdin, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<int, A...> fscanf(FILE* stream, const char* format, A... arguments) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_fscanf(stream, format, slots, sizeof...(A));
}

template <typename... A>
inline ros2wasm::lp64::If<int, A...> sscanf(const char* from, const char* format, A... arguments) {
  const ros2wasm::lp64::Slot slots[] = {ros2wasm::lp64::slot(arguments)...};
  return ros2wasm_lp64_sscanf(from, format, slots, sizeof...(A));
}
}
#endif
