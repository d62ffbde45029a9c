/* Included before the engine's files: qsort_r() of glibc, which the C library of the site's
 * compiler may lack. */
#pragma once
#include <stddef.h>
#include <stdlib.h>

#ifdef __cplusplus
extern "C"
#endif
    void
    ros2wasm_mujoco_qsort_r(void* base, size_t count, size_t size,
                            int (*order)(const void*, const void*, void*), void* context);
#define qsort_r ros2wasm_mujoco_qsort_r
