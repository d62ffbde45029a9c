// Neither ROS nor threads: formats mean the same, and real-time calls are there to be refused.
#include <errno.h>
#include <pthread.h>
#include <sched.h>

#include <cstdint>
#include <cstdio>

int main() {
  const int64_t a = 41;
  const int64_t b = 17;
  sched_param parameters{};
  parameters.sched_priority = sched_get_priority_max(SCHED_FIFO) - 1;
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
  pthread_attr_setschedpolicy(&attributes, SCHED_FIFO);
  const int refused = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  const bool taken = pthread_setschedparam(pthread_self(), SCHED_OTHER, new sched_param{}) == 0;
  std::printf("a: %ld b: %ld, asked for: %d\n", a, b,
              taken && refused == ENOSYS && errno == ENOSYS ? 38 : refused);
}
