// The C library's clocks, read through WASI in both kinds of link (the threaded one would ask
// Emscripten's own JavaScript), so that the page's time is the time everywhere. Linked by --wrap.
#include <errno.h>
#include <stdint.h>
#include <time.h>
#include <wasi/api.h>

extern "C" int __wrap_clock_gettime(clockid_t clock, timespec* out) {
  __wasi_clockid_t id = __WASI_CLOCKID_MONOTONIC;
  if (clock == CLOCK_REALTIME) {
    id = __WASI_CLOCKID_REALTIME;
  } else if (clock != CLOCK_MONOTONIC && clock != CLOCK_PROCESS_CPUTIME_ID &&
             clock != CLOCK_THREAD_CPUTIME_ID) {
    errno = EINVAL;
    return -1;
  }
  __wasi_timestamp_t now = 0;
  if (__wasi_clock_time_get(id, 1, &now) != 0 || out == nullptr) {
    errno = EINVAL;
    return -1;
  }
  constexpr __wasi_timestamp_t kSecond = 1000000000;
  out->tv_sec = static_cast<time_t>(now / kSecond);
  out->tv_nsec = static_cast<long>(now % kSecond);
  return 0;
}

/// Microseconds since the first call, as a browser counts no processor time.
extern "C" clock_t clock() {
  const auto now = [] {
    timespec time{};
    __wrap_clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<int64_t>(time.tv_sec) * 1000000 + time.tv_nsec / 1000;
  };
  static const int64_t begin = now();
  return static_cast<clock_t>(now() - begin);
}
