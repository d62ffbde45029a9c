// Divides by zero, deep down.
#include <stdio.h>

__attribute__((noinline)) int ratio(volatile int a, volatile int b) { return a / b; }

int main(int argc, char** argv) {
  (void)argv;
  puts("dividing");
  fflush(stdout);
  return ratio(argc, argc - argc);
}
