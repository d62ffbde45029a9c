// Repeats its input line by line; "quit" ends it with code 7. Prints its arguments and one variable first.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char** argv) {
  for (int i = 0; i < argc; ++i) printf("argument %d: %s\n", i, argv[i]);
  printf("COLOUR=%s\n", getenv("COLOUR"));
  printf("what? ");
  fflush(stdout);
  char line[256];
  while (fgets(line, sizeof line, stdin)) {
    if (strcmp(line, "quit\n") == 0) return 7;
    printf("echo %s", line);
    fflush(stdout);
  }
  return 0;
}
