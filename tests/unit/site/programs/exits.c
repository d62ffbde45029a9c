// Ends at once with the code that its first own argument names.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char** argv) {
  for (int i = 1; i + 1 < argc; ++i) {
    if (strcmp(argv[i], "--code") == 0) {
      fprintf(stderr, "ending with %s", argv[i + 1]);
      exit(atoi(argv[i + 1]));
    }
  }
  return 0;
}
