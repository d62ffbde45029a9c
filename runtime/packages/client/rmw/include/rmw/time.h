// Seconds and nanoseconds, unsigned; the largest value means "for ever".
#ifndef RMW__TIME_H_
#define RMW__TIME_H_

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct rmw_time_s {
  uint64_t sec;
  uint64_t nsec;
} rmw_time_t;

typedef int64_t rmw_duration_t;

#define RMW_DURATION_INFINITE_SEC 9223372036LL
#define RMW_DURATION_INFINITE_NSEC 854775807LL
#define RMW_DURATION_INFINITE \
  { RMW_DURATION_INFINITE_SEC, RMW_DURATION_INFINITE_NSEC }

static inline rmw_duration_t rmw_time_total_nsec(const rmw_time_t time) {
  const uint64_t most = INT64_MAX;
  if (time.sec > most / 1000000000u) {
    return INT64_MAX;
  }
  const uint64_t seconds = time.sec * 1000000000u;
  return time.nsec > most - seconds ? INT64_MAX : (rmw_duration_t)(seconds + time.nsec);
}

static inline rmw_time_t rmw_time_from_nsec(const rmw_duration_t nanoseconds) {
  if (nanoseconds < 0) {
    const rmw_time_t forever = RMW_DURATION_INFINITE;
    return forever;
  }
  const rmw_time_t time = {(uint64_t)nanoseconds / 1000000000u,
                           (uint64_t)nanoseconds % 1000000000u};
  return time;
}

static inline rmw_time_t rmw_time_normalize(const rmw_time_t time) {
  return rmw_time_from_nsec(rmw_time_total_nsec(time));
}

static inline bool rmw_time_equal(const rmw_time_t left, const rmw_time_t right) {
  return rmw_time_total_nsec(left) == rmw_time_total_nsec(right);
}

#ifdef __cplusplus
}
#endif

#endif  // RMW__TIME_H_
