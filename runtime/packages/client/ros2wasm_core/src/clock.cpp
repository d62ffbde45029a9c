// The C library's clocks, read through WASI in both kinds of link (the threaded one would ask
// Emscripten's own JavaScript), so that the page's time is the time everywhere. Linked by --wrap.
#include <errno.h>
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
