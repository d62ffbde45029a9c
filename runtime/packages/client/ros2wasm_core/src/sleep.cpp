// The C library's sleeping calls, sent to the loader's `sleep`, so that a blocked worker really
// blocks, a stop wakes it, and paused time holds it. Linked by --wrap.
#include <emscripten/threading.h>
#include <errno.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

#include "ros2wasm/endpoint.hpp"

namespace {

constexpr int64_t kSecond = 1000000000;

int64_t to_ns(const timespec* time) {
  return static_cast<int64_t>(time->tv_sec) * kSecond + time->tv_nsec;
}

bool valid(const timespec* time) {
  return time != nullptr && time->tv_sec >= 0 && time->tv_nsec >= 0 && time->tv_nsec < kSecond;
}

// Sleeps; what is left goes to `remaining`. Returns 0 or EINTR.
int sleep_ns(int64_t duration_ns, timespec* remaining) {
  const int64_t until = ros2wasm::steady_now_ns() + duration_ns;
  if (ros2wasm::sleep_for(duration_ns)) {
    return 0;
  }
  const int64_t left = until - ros2wasm::steady_now_ns();
  if (remaining != nullptr) {
    remaining->tv_sec = left > 0 ? static_cast<time_t>(left / kSecond) : 0;
    remaining->tv_nsec = left > 0 ? static_cast<long>(left % kSecond) : 0;
  }
  return left > 0 ? EINTR : 0;
}

}  // namespace

extern "C" {

int __wrap_nanosleep(const timespec* duration, timespec* remaining) {
  if (!valid(duration)) {
    errno = EINVAL;
    return -1;
  }
  const int error = sleep_ns(to_ns(duration), remaining);
  if (error != 0) {
    errno = error;
    return -1;
  }
  return 0;
}

int __wrap_clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* remaining) {
  if (!valid(time)) {
    return EINVAL;
  }
  if ((flags & TIMER_ABSTIME) == 0) {
    return sleep_ns(to_ns(time), remaining);
  }
  const int64_t now =
      clock == CLOCK_REALTIME ? ros2wasm::system_now_ns() : ros2wasm::steady_now_ns();
  const int64_t left = to_ns(time) - now;
  return left > 0 ? sleep_ns(left, nullptr) : 0;
}

int __wrap_usleep(useconds_t microseconds) {
  const int error = sleep_ns(static_cast<int64_t>(microseconds) * 1000, nullptr);
  if (error != 0) {
    errno = error;
    return -1;
  }
  return 0;
}

int __real_pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                  const timespec* until);

// Nobody can signal a program without threads while it waits: what is left of the wait is a sleep.
// The C library's stand-in would return at once, and the caller would try again until the time is
// over.
int __wrap_pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                  const timespec* until) {
  if (emscripten_has_threading_support() != 0) {
    return __real_pthread_cond_timedwait(condition, mutex, until);
  }
  const int error = __wrap_clock_nanosleep(CLOCK_REALTIME, TIMER_ABSTIME, until, nullptr);
  return error == 0 ? ETIMEDOUT : error == EINTR ? 0 : error;
}

unsigned __wrap_sleep(unsigned seconds) {
  timespec remaining{};
  if (sleep_ns(static_cast<int64_t>(seconds) * kSecond, &remaining) == 0) {
    return 0;
  }
  return static_cast<unsigned>(remaining.tv_sec) + (remaining.tv_nsec > 0 ? 1 : 0);
}

}  // extern "C"
