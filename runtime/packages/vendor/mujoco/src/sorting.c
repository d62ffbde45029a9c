// A heap sort, so it needs no memory and has no slow inputs. See sorting.h.
#include "sorting.h"

typedef int (*Order)(const void*, const void*, void*);

static void swap(char* a, char* b, size_t size) {
  for (size_t i = 0; i < size; i++) {
    const char byte = a[i];
    a[i] = b[i];
    b[i] = byte;
  }
}

static void sink(char* items, size_t from, size_t count, size_t size, Order order, void* context) {
  for (size_t child = 2 * from + 1; child < count; child = 2 * from + 1) {
    if (child + 1 < count && order(items + child * size, items + (child + 1) * size, context) < 0) child++;
    if (order(items + from * size, items + child * size, context) >= 0) return;
    swap(items + from * size, items + child * size, size);
    from = child;
  }
}

void ros2wasm_mujoco_qsort_r(void* base, size_t count, size_t size, Order order, void* context) {
  char* items = base;
  for (size_t i = count / 2; i > 0; i--) sink(items, i - 1, count, size, order, context);
  for (size_t end = count; end > 1; end--) {
    swap(items, items + (end - 1) * size, size);
    sink(items, 0, end - 1, size, order, context);
  }
}
