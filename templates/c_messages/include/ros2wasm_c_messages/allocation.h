// The allocator of the generated functions: the program's own malloc.
#ifndef ROS2WASM_C_MESSAGES__ALLOCATION_H_
#define ROS2WASM_C_MESSAGES__ALLOCATION_H_

#include <stddef.h>
#include <stdlib.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ros2wasm_allocator_t {
  void * (* allocate)(size_t size, void * state);
  void (* deallocate)(void * pointer, void * state);
  void * (* reallocate)(void * pointer, size_t size, void * state);
  void * (* zero_allocate)(size_t count, size_t size, void * state);
  void * state;
} ros2wasm_allocator_t;

static inline void * ros2wasm_allocate(size_t size, void * state)
{
  (void)state;
  return malloc(size);
}

static inline void ros2wasm_deallocate(void * pointer, void * state)
{
  (void)state;
  free(pointer);
}

static inline void * ros2wasm_reallocate(void * pointer, size_t size, void * state)
{
  (void)state;
  return realloc(pointer, size);
}

static inline void * ros2wasm_zero_allocate(size_t count, size_t size, void * state)
{
  (void)state;
  return calloc(count, size);
}

static inline ros2wasm_allocator_t ros2wasm_default_allocator(void)
{
  ros2wasm_allocator_t result;
  result.allocate = ros2wasm_allocate;
  result.deallocate = ros2wasm_deallocate;
  result.reallocate = ros2wasm_reallocate;
  result.zero_allocate = ros2wasm_zero_allocate;
  result.state = NULL;
  return result;
}

#ifdef __cplusplus
}
#endif

#endif  // ROS2WASM_C_MESSAGES__ALLOCATION_H_
