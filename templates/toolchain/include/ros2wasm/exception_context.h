/* Included into every file that is compiled for a site.
 * libunwind keeps the landing pad of the exception in flight in a thread-local variable, but clang 14
 * refers to it as an ordinary one; an object that merely declares it as it is makes the linker
 * see one kind of symbol, and typed catch works in every thread. */
#ifndef ROS2WASM_EXCEPTION_CONTEXT_H_
#define ROS2WASM_EXCEPTION_CONTEXT_H_
#ifndef __ASSEMBLER__
#ifdef __cplusplus
extern "C" {
#endif
struct ros2wasm_landing_pad_context {
  int landing_pad_index;
  void* language_data;
  int selector;
};
extern __thread struct ros2wasm_landing_pad_context __wasm_lpad_context;
__attribute__((used)) static inline void* ros2wasm_landing_pad_context_reference(void) {
  return &__wasm_lpad_context;
}
#ifdef __cplusplus
}
#endif
#endif
#endif
