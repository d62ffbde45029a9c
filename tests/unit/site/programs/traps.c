// Divides by zero, deep down.
#include <stdio.h>

int ratio(volatile int a, volatile int b) { return a / b; }

// Called through a pointer, so that no optimiser joins it with main.
static int (*volatile divide)(int, int) = ratio;

int main(int argc, char** argv) {
  (void)argv;
  puts("dividing");
  fflush(stdout);
  return divide(argc, argc - argc);
}
