// The named quality of service profiles.
#ifndef RMW__QOS_PROFILES_H_
#define RMW__QOS_PROFILES_H_

#include "rmw/types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define RMW_QOS_PROFILE_OF_(DEPTH, RELIABILITY, DURABILITY)                            \
  {                                                                                    \
    RMW_QOS_POLICY_HISTORY_KEEP_LAST, DEPTH, RMW_QOS_POLICY_RELIABILITY_##RELIABILITY, \
        RMW_QOS_POLICY_DURABILITY_##DURABILITY, RMW_QOS_DEADLINE_DEFAULT,              \
        RMW_QOS_LIFESPAN_DEFAULT, RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,            \
        RMW_QOS_LIVELINESS_LEASE_DURATION_DEFAULT, false                               \
  }

static const rmw_qos_profile_t rmw_qos_profile_sensor_data =
    RMW_QOS_PROFILE_OF_(5, BEST_EFFORT, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_parameters =
    RMW_QOS_PROFILE_OF_(1000, RELIABLE, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_default =
    RMW_QOS_PROFILE_OF_(10, RELIABLE, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_services_default =
    RMW_QOS_PROFILE_OF_(10, RELIABLE, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_parameter_events =
    RMW_QOS_PROFILE_OF_(1000, RELIABLE, VOLATILE);
static const rmw_qos_profile_t rmw_qos_profile_rosout_default = {
    RMW_QOS_POLICY_HISTORY_KEEP_LAST,
    1000,
    RMW_QOS_POLICY_RELIABILITY_RELIABLE,
    RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
    RMW_QOS_DEADLINE_DEFAULT,
    {10, 0},
    RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
    RMW_QOS_LIVELINESS_LEASE_DURATION_DEFAULT,
    false};

#define RMW_QOS_POLICY_DEPTH_SYSTEM_DEFAULT 0

static const rmw_qos_profile_t rmw_qos_profile_system_default = {
    RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT,
    RMW_QOS_POLICY_DEPTH_SYSTEM_DEFAULT,
    RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
    RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT,
    RMW_QOS_DEADLINE_DEFAULT,
    RMW_QOS_LIFESPAN_DEFAULT,
    RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
    RMW_QOS_LIVELINESS_LEASE_DURATION_DEFAULT,
    false};
static const rmw_qos_profile_t rmw_qos_profile_best_available = {
    RMW_QOS_POLICY_HISTORY_KEEP_LAST,
    10,
    RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE,
    RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE,
    RMW_QOS_DEADLINE_BEST_AVAILABLE,
    RMW_QOS_LIFESPAN_DEFAULT,
    RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE,
    RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE,
    false};
static const rmw_qos_profile_t rmw_qos_profile_unknown = {RMW_QOS_POLICY_HISTORY_UNKNOWN,
                                                          RMW_QOS_POLICY_DEPTH_SYSTEM_DEFAULT,
                                                          RMW_QOS_POLICY_RELIABILITY_UNKNOWN,
                                                          RMW_QOS_POLICY_DURABILITY_UNKNOWN,
                                                          RMW_QOS_DEADLINE_DEFAULT,
                                                          RMW_QOS_LIFESPAN_DEFAULT,
                                                          RMW_QOS_POLICY_LIVELINESS_UNKNOWN,
                                                          RMW_QOS_LIVELINESS_LEASE_DURATION_DEFAULT,
                                                          false};

#ifdef __cplusplus
}
#endif

#endif  // RMW__QOS_PROFILES_H_
