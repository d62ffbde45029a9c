// Attributes of functions.
#ifndef RCL__MACROS_H_
#define RCL__MACROS_H_

#include "rcutils/macros.h"

#define RCL_WARN_UNUSED RCUTILS_WARN_UNUSED
#define RCL_UNUSED(x) RCUTILS_UNUSED(x)

#endif  // RCL__MACROS_H_
