/* Included before everything else that is compiled for the site.
 * clang 14 refers to libunwind's landing pad context as a plain symbol, while a threaded libunwind
 * defines it thread-local: typed catches then read another thread's memory. Declaring it here
 * thread-local, with one reference that stays, makes the compiler's own accesses thread-local. */
#ifndef ROS2WASM__EXCEPTION_CONTEXT_H_
#define ROS2WASM__EXCEPTION_CONTEXT_H_

#if defined(__wasm__) && !defined(__ASSEMBLER__)
#ifdef __cplusplus
extern "C" {
#endif
struct ros2wasm_landing_pad_context {
  int landing_pad_index;
  void* language_specific_data;
  int selector;
};
extern __thread struct ros2wasm_landing_pad_context __wasm_lpad_context;
static __attribute__((used)) inline void* ros2wasm_landing_pad_reference(void) {
  return &__wasm_lpad_context;
}
#ifdef __cplusplus
}
#endif
#endif

#endif  /* ROS2WASM__EXCEPTION_CONTEXT_H_ */
