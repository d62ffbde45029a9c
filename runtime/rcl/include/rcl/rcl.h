// The part of the C client library that C++ client code reads. Its functions are not offered.
#ifndef RCL__RCL_H_
#define RCL__RCL_H_

#include "rcl/allocator.h"
#include "rcl/error_handling.h"
#include "rcl/logging_rosout.h"
#include "rcl/service_introspection.h"
#include "rcl/time.h"
#include "rcl/types.h"
#include "rmw/rmw.h"

#endif  // RCL__RCL_H_
