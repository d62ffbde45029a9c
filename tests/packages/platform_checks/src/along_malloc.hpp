#pragma once
#include <malloc.h>

inline int allocator_takes_options() {
  return mallopt(M_MMAP_MAX, 0) + mallopt(M_TRIM_THRESHOLD, -1);
}
