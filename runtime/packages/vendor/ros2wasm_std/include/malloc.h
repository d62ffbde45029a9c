// C's header, with the options of glibc's mallopt(); the allocator of a site refuses those that it
// does not know.
#include_next <malloc.h>
#include <stdio.h>
#ifndef M_MMAP_MAX
#define M_MMAP_MAX (-4)
#define M_TOP_PAD (-2)
#define M_CHECK_ACTION (-5)
#define M_PERTURB (-6)
#define M_ARENA_TEST (-7)
#define M_ARENA_MAX (-8)
#endif
