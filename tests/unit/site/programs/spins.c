// Computes for ever and hears nothing, not even a stop.
#include <stdio.h>

int main(void) {
  puts("spinning");
  fflush(stdout);
  for (volatile unsigned n = 0;; ++n) {
  }
}
