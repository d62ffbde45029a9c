// What C libraries for the site lack of threads' scheduling: a browser lets nobody choose a CPU or
// a policy, and these say so, as on a system without them. Weak, for compilers whose library has
// them.
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <string.h>
#include <time.h>

#define ROS2WASM_LACKING __attribute__((weak))

namespace {

int refuse() {
  errno = ENOSYS;
  return -1;
}

}  // namespace

extern "C" {

ROS2WASM_LACKING int pthread_setaffinity_np(pthread_t, size_t, const cpu_set_t*) {
  return ENOSYS;
}

ROS2WASM_LACKING int pthread_getaffinity_np(pthread_t, size_t, cpu_set_t*) {
  return ENOSYS;
}

ROS2WASM_LACKING int sched_setaffinity(pid_t, size_t, const cpu_set_t*) {
  return refuse();
}

ROS2WASM_LACKING int sched_getaffinity(pid_t, size_t, cpu_set_t*) {
  return refuse();
}

ROS2WASM_LACKING int sched_setscheduler(pid_t, int, const sched_param*) {
  return refuse();
}

ROS2WASM_LACKING int sched_getscheduler(pid_t) {
  return refuse();
}

ROS2WASM_LACKING int sched_setparam(pid_t, const sched_param*) {
  return refuse();
}

ROS2WASM_LACKING int sched_getparam(pid_t, sched_param*) {
  return refuse();
}

ROS2WASM_LACKING int sched_rr_get_interval(pid_t, timespec*) {
  return refuse();
}

ROS2WASM_LACKING int sched_getcpu() {
  return refuse();
}

/// The name is shown nowhere. Linux takes 15 characters.
ROS2WASM_LACKING int pthread_setname_np(pthread_t, const char* name) {
  constexpr size_t kLongest = 15;
  return strnlen(name, kLongest + 1) > kLongest ? ERANGE : 0;
}

/// There is no clock of a thread's CPU time: the one that stands for it counts the time that goes
/// by, and what measures a thread by it goes on. The C library's own leaves `clock` as it was,
/// which few look at.
int pthread_getcpuclockid(pthread_t, clockid_t* clock) {
  *clock = CLOCK_THREAD_CPUTIME_ID;
  return 0;
}

}  // extern "C"
