/* effects_manual FILE: the manual of the effects, docs/effects.md, written when the program is
 * built. */
#include <stdio.h>

#include "app/client.h"

int main(int argc, char **argv)
{
  if (argc != 2) {
    fputs("usage: effects_manual FILE\n", stderr);
    return 2;
  }
  struct umbra *umbra;
  if (umbra_open(NULL, &umbra) != UMBRA_OK) {
    fputs("out of memory\n", stderr);
    return 1;
  }
  FILE *file = fopen(argv[1], "w");
  if (file == NULL) {
    perror(argv[1]);
    return 1;
  }
  um_app_effect_manual(file, umbra);
  umbra_close(&umbra);
  if (ferror(file) != 0 || fclose(file) != 0) {
    perror(argv[1]);
    return 1;
  }
  return 0;
}
