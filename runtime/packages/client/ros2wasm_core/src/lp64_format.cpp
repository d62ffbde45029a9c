// Formats of printf and scanf by the widths of a 64-bit machine: the functions behind the overloads
// of ros2wasm_std. Each writes the format anew (`%ld` becomes `%lld`, numbered arguments come in
// their order) and lays the arguments out as the compiler lays out those of `...`; C's function
// does the rest.
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <syslog.h>

#include <cstdint>

#include "ros2wasm/lp64_format.hpp"

#include <cstdio>

namespace {

using ros2wasm::lp64::Slot;

constexpr int kPointee64 = 8;  // the mark above a pointer that leads to a 64-bit integer

bool is_one_of(char one, const char* among) {
  return one != '\0' && strchr(among, one) != nullptr;
}

/// Writes the format and the arguments into room that is large enough: of each character of the
/// format at most two come, and at most 12 bytes of arguments (`%Lf`: 16 bytes, and 12 of padding).
class Translation {
 public:
  static constexpr size_t kArgumentBytes = 12;
  static size_t room(size_t length) {
    return (2 + kArgumentBytes) * length + 1 + alignof(long double);
  }

  /// `room` is aligned as a long double.
  Translation(const char* format, size_t length, const Slot* slots, int count, char* room)
      : read_(format),
        slots_(slots),
        count_(count),
        arguments_(room),
        arguments_end_(room),
        format_(room + kArgumentBytes * length),
        format_end_(format_) {}

  void print() {
    while (to_conversion()) {
      const int number = numbered();
      while (is_one_of(*read_, "-+ #0'I")) put(*read_++);
      width();
      if (*read_ == '.') {
        put(*read_++);
        width();
      }
      modifiers();
      printed(number);
    }
    *format_end_ = '\0';
  }

  void scan() {
    while (to_conversion()) {
      const int number = numbered();
      const bool is_skipped = *read_ == '*';
      while (is_one_of(*read_, "*'0123456789m")) put(*read_++);
      modifiers();
      scanned(number, is_skipped);
    }
    *format_end_ = '\0';
  }

  const char* format() const { return format_; }
  /// The compiler's list of arguments is the address of the first.
  va_list& arguments() { return arguments_; }

 private:
  void put(char one) { *format_end_++ = one; }

  /// Copies up to a conversion and its `%`; false at the end.
  bool to_conversion() {
    for (; *read_ != '\0'; put(*read_++)) {
      if (*read_ != '%') continue;
      put(*read_++);
      return true;
    }
    return false;
  }

  /// The place of `2$`, which is not copied; else -1.
  int numbered() {
    char* end = nullptr;
    if (!is_one_of(*read_, "123456789")) return -1;
    const int number = static_cast<int>(strtol(read_, &end, 10));
    if (*end != '$') return -1;
    read_ = end + 1;
    return number - 1;
  }

  void width() {
    if (*read_ == '*') {
      put(*read_++);
      push(static_cast<int>(take(numbered())));
    }
    while (is_one_of(*read_, "0123456789")) put(*read_++);
  }

  void modifiers() {
    modifier_ = read_;
    while (is_one_of(*read_, "hlqjztL")) ++read_;
    is_wide_ = modifier_ != read_ && is_one_of(*modifier_, "lqjzt");
  }
  void put_modifier() {
    for (const char* one = modifier_; one != read_; ++one) put(*one);
  }
  void put_width(bool is_of_64_bits) {
    if (!is_wide_) return put_modifier();
    put('l');
    if (is_of_64_bits) put('l');
  }

  /// An argument that is missing is 0.
  Slot take(int number) {
    const int place = number < 0 ? next_++ : number;
    return place < count_ ? slots_[place] : 0;
  }

  template <typename T>
  void push(T value) {
    const uintptr_t mask = alignof(T) - 1;
    arguments_end_ =
        reinterpret_cast<char*>((reinterpret_cast<uintptr_t>(arguments_end_) + mask) & ~mask);
    memcpy(arguments_end_, &value, sizeof(value));
    arguments_end_ += sizeof(value);
  }
  void push_address(Slot slot) { push(static_cast<uintptr_t>(slot)); }
  void push_written(Slot slot) {
    put_width(slot >> 32 == kPointee64);
    push_address(slot);
  }

  void printed(int number) {
    const char conversion = *read_;
    if (is_one_of(conversion, "dioxXu")) {
      put_width(true);
      const Slot value = take(number);
      if (is_wide_)
        push(value);
      else
        push(static_cast<int>(value));
    } else if (is_one_of(conversion, "aAeEfFgG")) {
      put_modifier();
      const Slot value = take(number);
      if (*modifier_ != 'L')
        push(value);
      else
        push(value == 0 ? 0.0L
                        : *reinterpret_cast<const long double*>(static_cast<uintptr_t>(value)));
    } else if (conversion == 'n') {
      push_written(take(number));
    } else if (conversion == 'p') {
      const Slot value = take(number);
      ++read_;
      put(static_cast<uint32_t>(value) == 0 ? 's' : 'p');
      return push_address(static_cast<uint32_t>(value) == 0 ? reinterpret_cast<uintptr_t>("(nil)")
                                                            : value);
    } else if (conversion == 'm') {
      ++read_;
      put('s');
      return push_address(reinterpret_cast<uintptr_t>(strerror(error_)));
    } else if (is_one_of(conversion, "csCS")) {
      put_modifier();
      push_address(take(number));
    } else {
      put_modifier();
    }
    if (conversion != '\0') put(*read_++);
  }

  void scanned(int number, bool is_skipped) {
    const char conversion = *read_;
    const bool takes = !is_skipped && is_one_of(conversion, "dioxXunaAeEfFgGcsCSp[");
    if (!takes)
      put_modifier();
    else if (is_one_of(conversion, "dioxXun"))
      push_written(take(number));
    else {
      put_modifier();
      push_address(take(number));
    }
    if (conversion != '\0') put(*read_++);
    if (conversion != '[') return;
    if (*read_ == '^') put(*read_++);
    if (*read_ == ']') put(*read_++);
    while (*read_ != '\0' && *read_ != ']') put(*read_++);
  }

  const char* read_;
  const Slot* slots_;
  int count_;
  int next_ = 0;
  int error_ = errno;  // that of the call
  const char* modifier_ = nullptr;
  bool is_wide_ = false;
  va_list arguments_;
  char* arguments_end_;
  char* format_;
  char* format_end_;
};

struct Target {
  void* to;
  size_t size;
};

}  // namespace

extern "C" {

int ros2wasm_lp64_arguments(const char* format, const Slot* slots, int count, bool reads,
                            int (*then)(void*, const char*, va_list), void* context) {
  alignas(long double) char small[1024];
  const size_t length = strlen(format);
  const size_t size = Translation::room(length);
  char* room = size <= sizeof(small) ? small : static_cast<char*>(malloc(size));
  if (room == nullptr) return -1;
  Translation translation(format, length, slots, count, room);
  if (reads)
    translation.scan();
  else
    translation.print();
  const int result = then(context, translation.format(), translation.arguments());
  if (room != small) free(room);
  return result;
}

int ros2wasm_lp64_fprintf(FILE* stream, const char* format, const Slot* slots, int count) {
  return ros2wasm_lp64_arguments(
      format, slots, count, false,
      [](void* to, const char* text, va_list arguments) {
        return vfprintf(static_cast<FILE*>(to), text, arguments);
      },
      stream);
}

int ros2wasm_lp64_snprintf(char* to, size_t size, const char* format, const Slot* slots,
                           int count) {
  Target target{to, size};
  return ros2wasm_lp64_arguments(
      format, slots, count, false,
      [](void* context, const char* text, va_list arguments) {
        const Target* place = static_cast<Target*>(context);
        return vsnprintf(static_cast<char*>(place->to), place->size, text, arguments);
      },
      &target);
}

int ros2wasm_lp64_asprintf(char** to, const char* format, const Slot* slots, int count) {
  return ros2wasm_lp64_arguments(
      format, slots, count, false,
      [](void* place, const char* text, va_list arguments) {
        return vasprintf(static_cast<char**>(place), text, arguments);
      },
      to);
}

int ros2wasm_lp64_dprintf(int to, const char* format, const Slot* slots, int count) {
  return ros2wasm_lp64_arguments(
      format, slots, count, false,
      [](void* place, const char* text, va_list arguments) {
        return vdprintf(*static_cast<int*>(place), text, arguments);
      },
      &to);
}

int ros2wasm_lp64_fscanf(FILE* stream, const char* format, const Slot* slots, int count) {
  return ros2wasm_lp64_arguments(
      format, slots, count, true,
      [](void* from, const char* text, va_list arguments) {
        return vfscanf(static_cast<FILE*>(from), text, arguments);
      },
      stream);
}

int ros2wasm_lp64_sscanf(const char* from, const char* format, const Slot* slots, int count) {
  return ros2wasm_lp64_arguments(
      format, slots, count, true,
      [](void* text_from, const char* text, va_list arguments) {
        return vsscanf(static_cast<const char*>(text_from), text, arguments);
      },
      const_cast<char*>(from));
}

void ros2wasm_lp64_syslog(int priority, const char* format, const Slot* slots, int count) {
  ros2wasm_lp64_arguments(
      format, slots, count, false,
      [](void* context, const char* text, va_list arguments) {
        vsyslog(*static_cast<int*>(context), text, arguments);
        return 0;
      },
      &priority);
}
}
