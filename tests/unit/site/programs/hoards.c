// Takes all the memory that it can have, writes to each piece of it, and goes on without more.
#include <stdio.h>
#include <stdlib.h>

// So that the compiler believes that somebody wants the pieces.
static char* volatile last;

int main(void) {
  const size_t piece = 64u << 20;
  int pieces = 0;
  for (char* at; (at = malloc(piece)) != NULL; ++pieces) {
    *at = 1;
    last = at;
  }
  printf("%d pieces and no more\n", pieces);
  return pieces > 0 ? 0 : 1;
}
