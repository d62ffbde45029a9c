// The part of the C client library that C++ client code reads. Of its functions only those of guard
// conditions and wait sets are offered.
#ifndef RCL__RCL_H_
#define RCL__RCL_H_

#include "rcl/allocator.h"
#include "rcl/context.h"
#include "rcl/error_handling.h"
#include "rcl/event.h"
#include "rcl/guard_condition.h"
#include "rcl/logging_rosout.h"
#include "rcl/service_introspection.h"
#include "rcl/time.h"
#include "rcl/types.h"
#include "rcl/wait.h"
#include "rmw/rmw.h"

#endif  // RCL__RCL_H_
