/* Tells the loader where the stack of a thread lies, so that it need not know the C library's
 * structs. Called in the creating thread's instance. */
#define _GNU_SOURCE
#include <pthread.h>
#include <stdint.h>

/* out[0]: highest address, out[1]: size in bytes. 0, or an errno. */
__attribute__((used, visibility("default")))
int32_t ros2wasm_thread_stack(pthread_t thread, uint32_t out[2]) {
  pthread_attr_t attributes;
  void* lowest = 0;
  size_t size = 0;
  int error = pthread_getattr_np(thread, &attributes);
  if (error != 0) {
    return error;
  }
  error = pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  out[0] = (uint32_t)(uintptr_t)lowest + (uint32_t)size;
  out[1] = (uint32_t)size;
  return error;
}
