// Format strings mean here what they mean on the 64-bit machines that ROS 2's code is written for:
// `%ld` prints 64 bits. `long` has 32 bits in a site and int64_t is a long long, so C's own
// functions would read half of an int64_t for `%ld`, and all that follows from the wrong place.
// Overloads of the families of printf and scanf hand each argument on in 64 bits of its own, as
// registers do there; ros2wasm_core reads the format by that rule
// (runtime/packages/client/ros2wasm_core/src/lp64_format.cpp). Every <stdio.h> of C++ includes this
// header, so it includes none itself. Before C++11 the overloads are not there.
#ifndef ROS2WASM_LP64_FORMAT_HPP_
#define ROS2WASM_LP64_FORMAT_HPP_
#if defined(__cplusplus) && __cplusplus >= 201103L
extern "C++" {
namespace ros2wasm {
namespace lp64 {

/// Holds one argument. An integer is extended by its sign; a double is its bits; a long double is
/// its address; a pointer has 32 bits, and above them 8 when a 64-bit integer can be written to
/// where it leads.
using Slot = unsigned long long;
using Address = __UINTPTR_TYPE__;

constexpr Slot slot(int value) {
  return static_cast<Slot>(value);
}
constexpr Slot slot(unsigned value) {
  return value;
}
constexpr Slot slot(long value) {
  return static_cast<Slot>(value);
}
constexpr Slot slot(unsigned long value) {
  return value;
}
constexpr Slot slot(long long value) {
  return static_cast<Slot>(value);
}
constexpr Slot slot(unsigned long long value) {
  return value;
}
inline Slot slot(double value) {
  return __builtin_bit_cast(Slot, value);
}
inline Slot slot(const long double& value) {
  return reinterpret_cast<Address>(&value);
}
inline Slot slot(const volatile void* value) {
  return reinterpret_cast<Address>(value);
}
inline Slot slot(long long* value) {
  return reinterpret_cast<Address>(value) | 8ULL << 32;
}
inline Slot slot(unsigned long long* value) {
  return reinterpret_cast<Address>(value) | 8ULL << 32;
}
template <typename Result, typename... Parameters>
Slot slot(Result (*value)(Parameters...)) {
  return reinterpret_cast<Address>(value);
}

template <typename T>
T given();
template <typename Result, typename... Slots>
struct First {
  using type = Result;
};
/// Result, where each argument has a slot. An object of a class has none: the call is then that of
/// C's function, which the compiler refuses.
template <typename Result, typename... A>
using If = typename First<Result, decltype(slot(given<A&>()))...>::type;

#if __cplusplus >= 201402L
/// The kinds of arguments that -Wformat tells from each other. A wide number has 64 bits on a
/// 64-bit machine.
enum class Kind { kNumber, kWideNumber, kFloat, kLongFloat, kText, kPointer };
enum class Fault { kNone, kCount, kKind };

template <typename T>
struct KindOf {
  static constexpr Kind value =
      __is_same(T, long double)                                             ? Kind::kLongFloat
      : __is_floating_point(T)                                              ? Kind::kFloat
      : __is_pointer(T) || __is_same(T, decltype(nullptr))                  ? Kind::kPointer
      : sizeof(T) == 8 || __is_same(T, long) || __is_same(T, unsigned long) ? Kind::kWideNumber
                                                                            : Kind::kNumber;
};
template <>
struct KindOf<char*> {
  static constexpr Kind value = Kind::kText;
};
template <>
struct KindOf<const char*> {
  static constexpr Kind value = Kind::kText;
};

constexpr bool is_among(char one, const char* among) {
  for (; *among; ++among)
    if (*among == one) return true;
  return false;
}

/// Whether a conversion with the modifiers of 64 bits (`wide`) or of long double takes such an
/// argument.
constexpr bool takes(char conversion, bool wide, bool long_float, Kind kind) {
  if (is_among(conversion, "dioxXu")) return kind == (wide ? Kind::kWideNumber : Kind::kNumber);
  if (is_among(conversion, "aAeEfFgG"))
    return kind == (long_float ? Kind::kLongFloat : Kind::kFloat);
  if (conversion == 'c' || conversion == 'C') return kind == Kind::kNumber;
  if (conversion == 's' && !wide) return kind == Kind::kText;
  return kind == Kind::kPointer || kind == Kind::kText;
}

/// The first fault of a format of printf; formats that name their arguments by number are not
/// looked at.
constexpr Fault fault_of(const char* format, const Kind* kinds, int count) {
  int used = 0;
  while (*format) {
    if (*format++ != '%') continue;
    bool wide = false;
    bool long_float = false;
    for (; is_among(*format, "-+ #0'123456789.*hlqjztL$"); ++format) {
      if (*format == '$') return Fault::kNone;
      if (*format == '*' && used < count && kinds[used] != Kind::kNumber) return Fault::kKind;
      if (*format == '*') ++used;
      wide = wide || is_among(*format, "lqjzt");
      long_float = long_float || *format == 'L';
    }
    if (*format == '\0') break;
    const char conversion = *format++;
    if (conversion == '%' || conversion == 'm') continue;
    if (used < count && !takes(conversion, wide, long_float, kinds[used])) return Fault::kKind;
    ++used;
  }
  return used == count ? Fault::kNone : Fault::kCount;
}

template <typename... A>
constexpr Fault fault(const char* format) {
  const Kind kinds[] = {KindOf<A>::value..., Kind::kNumber};
  return fault_of(format, kinds, sizeof...(A));
}
#endif

}  // namespace lp64
}  // namespace ros2wasm

/// Calls `then` with the format and the arguments as C's functions read them here, and returns what
/// it returns; -1 with ENOMEM when there is no memory. The format is one of scanf's where `reads`
/// says so. `count` is that of the slots.
extern "C" int ros2wasm_lp64_arguments(
    const char* format, const ros2wasm::lp64::Slot* slots, int count, bool reads,
    int (*then)(void* context, const char* format, __builtin_va_list arguments), void* context);

/// A warning of the compiler where the format is known and does not fit, as -Wformat would say
/// natively.
#if __cplusplus >= 201402L
#define ROS2WASM_LP64_CHECKED(format)                                                              \
  __attribute__((                                                                                  \
      diagnose_if(ros2wasm::lp64::fault<A...>(format) == ros2wasm::lp64::Fault::kCount,            \
                  "the format has more or fewer conversions than there are arguments", "warning"), \
      diagnose_if(ros2wasm::lp64::fault<A...>(format) == ros2wasm::lp64::Fault::kKind,             \
                  "the format has a conversion that does not fit its argument", "warning")))
#else
#define ROS2WASM_LP64_CHECKED(format)
#endif
}
#endif
#endif
