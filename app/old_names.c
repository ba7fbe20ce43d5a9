/* Verbs that were called otherwise: their old names go on for one version. */
#include <stdlib.h>
#include <string.h>

#include "app/client.h"

#define UNTIL "0.6" /* the version that knows them no more */

/* The first that fits holds. */
static const struct um_app_old_name table[] = {
    {"materials", "material", NULL, .where = "--from-"},
    {"materials", "list", "materials", NULL},
    {"filters", "list", "filters", NULL},
    {"sensors", "list", "sensors", NULL},
    {"effects", "list", "effects", NULL},
    {"schema", "list", "keys", NULL},
    {"frame", "render", NULL, NULL},
    {"expand", "render", NULL, NULL},
    {"passes", "forecast", "--times", NULL},
};

const struct um_app_old_name *um_app_old_name_find(int argc, char **argv)
{
  for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
    const struct um_app_old_name *old = &table[i];
    if (argc < 2 || strcmp(argv[1], old->name) != 0) continue;
    bool fits = old->where == NULL;
    for (int k = 2; k < argc && !fits; k++)
      fits = strncmp(argv[k], old->where, strlen(old->where)) == 0;
    if (fits) return old;
  }
  return NULL;
}

char **um_app_old_name_translate(const struct um_app_old_name *old, int *argc, char **argv)
{
  int n = 0;
  char **out = calloc((size_t)*argc + 2, sizeof *out);
  if (out == NULL) return NULL;
  out[n++] = argv[0];
  out[n++] = (char *)old->verb;
  if (old->first != NULL) out[n++] = (char *)old->first;
  for (int i = 2; i < *argc; i++) out[n++] = argv[i];
  *argc = n;
  fprintf(stderr, "umbra %s is now umbra %s%s%s; the old name works until version " UNTIL "\n",
          old->name, old->verb, old->first != NULL ? " " : "",
          old->first != NULL ? old->first : "");
  return out;
}
