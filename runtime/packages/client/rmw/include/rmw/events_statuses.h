// The counters that event callbacks receive, all kinds.
#ifndef RMW__EVENTS_STATUSES_H_
#define RMW__EVENTS_STATUSES_H_

#include "rmw/incompatible_qos_events_statuses.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct rmw_liveliness_changed_status_s {
  int32_t alive_count;
  int32_t not_alive_count;
  int32_t alive_count_change;
  int32_t not_alive_count_change;
} rmw_liveliness_changed_status_t;

typedef struct rmw_liveliness_lost_status_s {
  int32_t total_count;
  int32_t total_count_change;
} rmw_liveliness_lost_status_t;

typedef struct rmw_message_lost_status_s {
  size_t total_count;
  size_t total_count_change;
} rmw_message_lost_status_t;

typedef struct rmw_offered_deadline_missed_status_s {
  int32_t total_count;
  int32_t total_count_change;
} rmw_offered_deadline_missed_status_t;

typedef struct rmw_requested_deadline_missed_status_s {
  int32_t total_count;
  int32_t total_count_change;
} rmw_requested_deadline_missed_status_t;

typedef struct rmw_incompatible_type_status_s {
  int32_t total_count;
  int32_t total_count_change;
} rmw_incompatible_type_status_t;

typedef struct rmw_matched_status_s {
  size_t total_count;
  size_t total_count_change;
  size_t current_count;
  int32_t current_count_change;
} rmw_matched_status_t;

#ifdef __cplusplus
}
#endif

#endif  // RMW__EVENTS_STATUSES_H_
