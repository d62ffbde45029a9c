// Functions for threads' scheduling that the C libraries for the site lack. In a browser a program
// cannot choose a CPU or a policy, so these fail as on a system without such a choice. They are
// weak, for compilers whose library has them.
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

/// For a function that returns its error. errno is set too, because callers print it.
int refused() {
  errno = ENOSYS;
  return ENOSYS;
}

}  // namespace

extern "C" {

ROS2WASM_LACKING int pthread_setaffinity_np(pthread_t, size_t, const cpu_set_t*) {
  return refused();
}

ROS2WASM_LACKING int pthread_getaffinity_np(pthread_t, size_t, cpu_set_t*) {
  return refused();
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

/// A thread has the ordinary policy and nothing else. Strong: the C library's own say that any was
/// taken.
int pthread_setschedparam(pthread_t, int policy, const sched_param* parameters) {
  return policy == SCHED_OTHER && parameters->sched_priority == 0 ? 0 : refused();
}

int pthread_getschedparam(pthread_t, int* policy, sched_param* parameters) {
  *policy = SCHED_OTHER;
  parameters->sched_priority = 0;
  return 0;
}

int pthread_setschedprio(pthread_t, int priority) {
  return priority == 0 ? 0 : refused();
}

/// Missing in a program without threads: attributes of threads that it does not make.
ROS2WASM_LACKING int pthread_attr_setinheritsched(pthread_attr_t*, int) {
  return 0;
}
ROS2WASM_LACKING int pthread_attr_setschedpolicy(pthread_attr_t*, int) {
  return 0;
}
ROS2WASM_LACKING int pthread_attr_setschedparam(pthread_attr_t*, const sched_param*) {
  return 0;
}

/// The range of Linux, by which programs choose what they ask for.
ROS2WASM_LACKING int sched_get_priority_max(int policy) {
  return policy == SCHED_FIFO || policy == SCHED_RR ? 99 : 0;
}
ROS2WASM_LACKING int sched_get_priority_min(int policy) {
  return policy == SCHED_FIFO || policy == SCHED_RR ? 1 : 0;
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
