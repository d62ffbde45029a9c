// A message as bytes: CDR with its 4-byte header.
#ifndef RMW__SERIALIZED_MESSAGE_H_
#define RMW__SERIALIZED_MESSAGE_H_

#include "rcutils/types/uint8_array.h"
#include "rmw/types.h"

#define rmw_get_zero_initialized_serialized_message() rcutils_get_zero_initialized_uint8_array()
#define rmw_serialized_message_init(message, capacity, allocator) \
  rcutils_uint8_array_init(message, capacity, allocator)
#define rmw_serialized_message_fini(message) rcutils_uint8_array_fini(message)
#define rmw_serialized_message_resize(message, size) rcutils_uint8_array_resize(message, size)

#endif  // RMW__SERIALIZED_MESSAGE_H_
