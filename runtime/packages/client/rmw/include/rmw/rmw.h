// The part of the middleware interface that client code reads: types, profiles, statuses.
// There is one middleware, so the functions of rmw are not offered.
#ifndef RMW__RMW_H_
#define RMW__RMW_H_

#include "rmw/events_statuses.h"
#include "rmw/qos_profiles.h"
#include "rmw/types.h"

#ifdef __cplusplus
extern "C" {
#endif

static inline const char* rmw_get_implementation_identifier(void) {
  return "rmw_wasm_cpp";
}

static inline const char* rmw_get_serialization_format(void) {
  return "cdr";
}

#ifdef __cplusplus
}
#endif

#endif  // RMW__RMW_H_
