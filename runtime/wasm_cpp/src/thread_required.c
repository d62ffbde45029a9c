/* Stands in for pthread_create in the first link of every program. Only a program that starts
 * threads pulls this object in, and the import tells the link driver to link it as a threaded
 * program. It never runs. */
#include <stdint.h>

__attribute__((import_module("ros2wasm"), import_name("thread_create_required")))
int32_t ros2wasm_thread_create_required(void*, void*, void*, void*);

int __wrap_pthread_create(void* thread, void* attributes, void* (*start)(void*), void* argument) {
  return ros2wasm_thread_create_required(thread, attributes, (void*)start, argument);
}
