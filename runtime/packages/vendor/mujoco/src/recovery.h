/* Included before files that leave a function by longjmp, which programs of a site do not have:
   they throw instead. The compiler of models catches what is thrown, frees the model and returns
   the error's text, as it does natively. */
#pragma once

#ifdef __cplusplus
#include <csetjmp>
#define ROS2WASM_NORETURN [[noreturn]]
extern "C" {
#else
#include <setjmp.h>
#define ROS2WASM_NORETURN _Noreturn
#endif
/* Throws the error of the convex hull with this number. */
ROS2WASM_NORETURN void ros2wasm_mujoco_hull_error(int number);
#ifdef __cplusplus
}
#endif

/* The compiler of models computes a few ranges in threads, which would bind the simulator to pages
   that share memory: each is computed when it is started. */
#ifdef __cplusplus
#include <pthread.h>
#define pthread_create(thread, attributes, run, argument) ((void)(run)(argument), 0)
#define pthread_join(thread, result) 0
#endif

#undef setjmp
#undef longjmp
#define setjmp(buffer) 0
#ifdef __cplusplus
/* user_model.cc writes `std::longjmp(...)` in its handler of errors, which has put the text into
 * `errortext`. */
#define longjmp(buffer, number) size_t(0), throw mjCError(nullptr, "engine error: %s", errortext)
#else
#define longjmp(buffer, number) ros2wasm_mujoco_hull_error(number)
#endif
