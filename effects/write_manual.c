/* effects_manual FILE: the manual of the effects, docs/effects.md, written when they are built. */
#include <stdio.h>

#include "effects/effects.h"

int main(int argc, char **argv)
{
  if (argc != 2) {
    fputs("usage: effects_manual FILE\n", stderr);
    return 2;
  }
  FILE *file = fopen(argv[1], "w");
  if (file == NULL) {
    perror(argv[1]);
    return 1;
  }
  um_effects_write_manual(file);
  if (ferror(file) != 0 || fclose(file) != 0) {
    perror(argv[1]);
    return 1;
  }
  return 0;
}
