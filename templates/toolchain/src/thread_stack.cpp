// Linked into every program that starts threads: tells the loader where the stack of a thread lies,
// so that it need not know the C library's structs. Called in the creating thread's instance.
#include <pthread.h>
#include <stdint.h>

/// out[0]: highest address, out[1]: size in bytes. Returns 0, or an errno.
extern "C" __attribute__((used, visibility("default"))) int32_t ros2wasm_thread_stack(
    pthread_t thread, uint32_t out[2]) {
  pthread_attr_t attributes;
  int error = pthread_getattr_np(thread, &attributes);
  if (error != 0) {
    return error;
  }
  void* lowest = nullptr;
  size_t size = 0;
  error = pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  out[0] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(lowest)) + static_cast<uint32_t>(size);
  out[1] = static_cast<uint32_t>(size);
  return error;
}
