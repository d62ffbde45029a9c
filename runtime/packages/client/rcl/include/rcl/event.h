// The kinds of events, and the name of one.
#ifndef RCL__EVENT_H_
#define RCL__EVENT_H_

#include "rmw/events_statuses.h"

/** Numbers as the bus knows them (StatusKind in runtime/protocol). */
enum rcl_subscription_event_type_e {
  RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 0,
  RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 1,
  RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2,
  RCL_SUBSCRIPTION_MESSAGE_LOST = 3,
  RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4,
  RCL_SUBSCRIPTION_MATCHED = 5,
};
typedef enum rcl_subscription_event_type_e rcl_subscription_event_type_t;

enum rcl_publisher_event_type_e {
  RCL_PUBLISHER_LIVELINESS_LOST = 6,
  RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 7,
  RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 8,
  RCL_PUBLISHER_INCOMPATIBLE_TYPE = 9,
  RCL_PUBLISHER_MATCHED = 10,
};
typedef enum rcl_publisher_event_type_e rcl_publisher_event_type_t;

typedef struct rcl_event_impl_s rcl_event_impl_t;
typedef struct rcl_event_s {
  rcl_event_impl_t* impl;
} rcl_event_t;

#endif  // RCL__EVENT_H_
