// Nothing is exported: programs are linked whole.
#ifndef RCL__VISIBILITY_CONTROL_H_
#define RCL__VISIBILITY_CONTROL_H_

#define RCL_PUBLIC
#define RCL_LOCAL

#endif  // RCL__VISIBILITY_CONTROL_H_
