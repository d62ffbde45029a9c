// The counters that event callbacks receive.
#ifndef RMW__INCOMPATIBLE_QOS_EVENTS_STATUSES_H_
#define RMW__INCOMPATIBLE_QOS_EVENTS_STATUSES_H_

#include "rmw/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct rmw_qos_incompatible_event_status_s {
  int32_t total_count;
  int32_t total_count_change;
  rmw_qos_policy_kind_t last_policy_kind;
} rmw_qos_incompatible_event_status_t;
typedef rmw_qos_incompatible_event_status_t rmw_requested_qos_incompatible_event_status_t;
typedef rmw_qos_incompatible_event_status_t rmw_offered_qos_incompatible_event_status_t;

#ifdef __cplusplus
}
#endif

#endif  // RMW__INCOMPATIBLE_QOS_EVENTS_STATUSES_H_
