// Linked into every program that starts threads: what the loader asks of it, and the C library's
// waits with a timeout, which follow the site's time here. Must not depend on any package.
#include <errno.h>
#include <pthread.h>
#include <stdint.h>
#include <time.h>

#include <atomic>

// --- where the stack of a thread lies, so that the loader need not know the C library's structs
// ---

/// out[0]: highest address, out[1]: size in bytes. Returns 0, or an errno. Called in the creating
/// thread's instance.
extern "C" __attribute__((used, visibility("default"))) int32_t ros2wasm_thread_stack(
    pthread_t thread, uint32_t out[2]) {
  pthread_attr_t attributes;
  int error = pthread_getattr_np(thread, &attributes);
  if (error != 0) {
    return error;
  }
  void* lowest = nullptr;
  size_t size = 0;
  error = pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  out[0] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(lowest)) + static_cast<uint32_t>(size);
  out[1] = static_cast<uint32_t>(size);
  return error;
}

// --- waits with a timeout: condition variables, futures, timed locks, semaphores ---

/// Real ns that `site_ns` take, negative: for ever. Returns the version of the law that it went by.
extern "C" __attribute__((import_module("ros2wasm"), import_name("real_timeout"))) int32_t
ros2wasm_real_timeout(int64_t* real_ns, int64_t site_ns);

namespace {

/// A place in the list that the page reads (runtime/site/program/thread_waits.ts): when time changes, it
/// wakes all whose version is an older one. Places are used again and never freed.
struct TimedWait {
  std::atomic<uint32_t> address;  ///< what is waited on; 0: nobody uses this place
  std::atomic<int32_t> version;   ///< of the law of time
  TimedWait* next;
};
static_assert(sizeof(TimedWait) == 12, "thread_waits.ts knows the layout");

constexpr int32_t kNoVersion = -1;
std::atomic<TimedWait*> waits{nullptr};

TimedWait& claim_place(uint32_t address) {
  for (TimedWait* place = waits; place != nullptr; place = place->next) {
    uint32_t unused = 0;
    if (place->address.compare_exchange_strong(unused, address)) {
      return *place;
    }
  }
  auto* place = new TimedWait{{address}, {kNoVersion}, waits};
  while (!waits.compare_exchange_weak(place->next, place)) {
  }
  return *place;
}

constexpr int64_t kSecond = 1000000000;

bool valid(const timespec* at) {
  return at->tv_nsec >= 0 && at->tv_nsec < kSecond;
}

int64_t left_until(clockid_t clock, const timespec* at) {
  timespec now{};
  clock_gettime(clock, &now);
  return (static_cast<int64_t>(at->tv_sec) - now.tv_sec) * kSecond + (at->tv_nsec - now.tv_nsec);
}

enum class Woken { yes, timeout };

/// Until somebody notifies the address, or the time is over; at once when the value is another.
Woken wait_on(volatile int* address, int value, int64_t timeout_ns) {
  constexpr int kTimedOut = 2;
  int* word = const_cast<int*>(address);
  return __builtin_wasm_memory_atomic_wait32(word, value, timeout_ns) == kTimedOut ? Woken::timeout
                                                                                   : Woken::yes;
}

}  // namespace

extern "C" {

/// Address of the list.
__attribute__((used, visibility("default"))) std::atomic<TimedWait*>* ros2wasm_timed_waits() {
  return &waits;
}

/// The C library's own, which reckons with real time: whoever waits with a timeout does it here.
/// 0, ETIMEDOUT or EINVAL; callers look again whatever woke them.
int __timedwait_cp(volatile int* address, int value, clockid_t clock, const timespec* at, int) {
  if (at == nullptr) {
    wait_on(address, value, -1);
    return 0;
  }
  if (!valid(at)) {
    return EINVAL;
  }
  while (true) {
    const int64_t left_ns = left_until(clock, at);
    if (left_ns <= 0) {
      return ETIMEDOUT;
    }
    // Listed before it looks at the time: a change is either seen here or told by the page.
    TimedWait& place = claim_place(static_cast<uint32_t>(reinterpret_cast<uintptr_t>(address)));
    int64_t real_ns = 0;
    place.version = ros2wasm_real_timeout(&real_ns, left_ns);
    const Woken woken = wait_on(address, value, real_ns);
    place.version = kNoVersion;
    place.address = 0;
    if (woken == Woken::yes) {
      return 0;
    }
  }
}

int __timedwait(volatile int* address, int value, clockid_t clock, const timespec* at, int shared) {
  return __timedwait_cp(address, value, clock, at, shared);
}

}  // extern "C"
