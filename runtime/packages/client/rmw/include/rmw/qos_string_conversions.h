// Policy values and kinds as the words that parameters and log lines use, and back.
#ifndef RMW__QOS_STRING_CONVERSIONS_H_
#define RMW__QOS_STRING_CONVERSIONS_H_

#include <string.h>

#include "rmw/types.h"

#ifdef __cplusplus
extern "C" {
#endif

static inline const char* rmw_qos_policy_kind_to_str(enum rmw_qos_policy_kind_e kind) {
  switch (kind) {
    case RMW_QOS_POLICY_DURABILITY:
      return "durability";
    case RMW_QOS_POLICY_DEADLINE:
      return "deadline";
    case RMW_QOS_POLICY_LIVELINESS:
      return "liveliness";
    case RMW_QOS_POLICY_RELIABILITY:
      return "reliability";
    case RMW_QOS_POLICY_HISTORY:
      return "history";
    case RMW_QOS_POLICY_LIFESPAN:
      return "lifespan";
    case RMW_QOS_POLICY_DEPTH:
      return "depth";
    case RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION:
      return "liveliness_lease_duration";
    case RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS:
      return "avoid_ros_namespace_conventions";
    default:
      return NULL;
  }
}

static inline const char* rmw_qos_durability_policy_to_str(enum rmw_qos_durability_policy_e v) {
  switch (v) {
    case RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT:
      return "system_default";
    case RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL:
      return "transient_local";
    case RMW_QOS_POLICY_DURABILITY_VOLATILE:
      return "volatile";
    case RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE:
      return "best_available";
    default:
      return NULL;
  }
}

static inline const char* rmw_qos_history_policy_to_str(enum rmw_qos_history_policy_e v) {
  switch (v) {
    case RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT:
      return "system_default";
    case RMW_QOS_POLICY_HISTORY_KEEP_LAST:
      return "keep_last";
    case RMW_QOS_POLICY_HISTORY_KEEP_ALL:
      return "keep_all";
    default:
      return NULL;
  }
}

static inline const char* rmw_qos_liveliness_policy_to_str(enum rmw_qos_liveliness_policy_e v) {
  switch (v) {
    case RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT:
      return "system_default";
    case RMW_QOS_POLICY_LIVELINESS_AUTOMATIC:
      return "automatic";
    case RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC:
      return "manual_by_topic";
    case RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE:
      return "best_available";
    default:
      return NULL;
  }
}

static inline const char* rmw_qos_reliability_policy_to_str(enum rmw_qos_reliability_policy_e v) {
  switch (v) {
    case RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT:
      return "system_default";
    case RMW_QOS_POLICY_RELIABILITY_RELIABLE:
      return "reliable";
    case RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT:
      return "best_effort";
    case RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE:
      return "best_available";
    default:
      return NULL;
  }
}

static inline enum rmw_qos_durability_policy_e rmw_qos_durability_policy_from_str(const char* s) {
  if (strcmp(s, "system_default") == 0) return RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT;
  if (strcmp(s, "transient_local") == 0) return RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  if (strcmp(s, "volatile") == 0) return RMW_QOS_POLICY_DURABILITY_VOLATILE;
  if (strcmp(s, "best_available") == 0) return RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE;
  return RMW_QOS_POLICY_DURABILITY_UNKNOWN;
}

static inline enum rmw_qos_history_policy_e rmw_qos_history_policy_from_str(const char* s) {
  if (strcmp(s, "system_default") == 0) return RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT;
  if (strcmp(s, "keep_last") == 0) return RMW_QOS_POLICY_HISTORY_KEEP_LAST;
  if (strcmp(s, "keep_all") == 0) return RMW_QOS_POLICY_HISTORY_KEEP_ALL;
  return RMW_QOS_POLICY_HISTORY_UNKNOWN;
}

static inline enum rmw_qos_liveliness_policy_e rmw_qos_liveliness_policy_from_str(const char* s) {
  if (strcmp(s, "system_default") == 0) return RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT;
  if (strcmp(s, "automatic") == 0) return RMW_QOS_POLICY_LIVELINESS_AUTOMATIC;
  if (strcmp(s, "manual_by_topic") == 0) return RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC;
  if (strcmp(s, "best_available") == 0) return RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE;
  return RMW_QOS_POLICY_LIVELINESS_UNKNOWN;
}

static inline enum rmw_qos_reliability_policy_e rmw_qos_reliability_policy_from_str(const char* s) {
  if (strcmp(s, "system_default") == 0) return RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT;
  if (strcmp(s, "reliable") == 0) return RMW_QOS_POLICY_RELIABILITY_RELIABLE;
  if (strcmp(s, "best_effort") == 0) return RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT;
  if (strcmp(s, "best_available") == 0) return RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE;
  return RMW_QOS_POLICY_RELIABILITY_UNKNOWN;
}

#ifdef __cplusplus
}
#endif

#endif  // RMW__QOS_STRING_CONVERSIONS_H_
