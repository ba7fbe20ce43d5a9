/* Verbs that were called otherwise: their old names go on for one version. */
#include <stdlib.h>
#include <string.h>

#include "app/client.h"

#define UNTIL "0.6" /* the version that knows them no more */

/* The first that fits holds. Not constant, as command lines are not. */
static struct um_app_old_name table[] = {
    {"materials", "material", "", .where = "--from-"},
    {"materials", "list", "materials", NULL},
    {"filters", "list", "filters", NULL},
    {"sensors", "list", "sensors", NULL},
    {"effects", "list", "effects", NULL},
    {"schema", "list", "keys", NULL},
    {"frame", "render", "", NULL},
    {"expand", "render", "", NULL},
    {"passes", "forecast", "--times", NULL},
    {"exchange", "export", "--as=exchange", NULL},
};

struct um_app_old_name *um_app_old_name_find(const char *name, int n, char *const *arguments)
{
  for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
    if (strcmp(name, table[i].name) != 0) continue;
    const char *where = table[i].where;
    bool fits = where == NULL;
    for (int k = 0; k < n && !fits; k++) fits = strncmp(arguments[k], where, strlen(where)) == 0;
    if (fits) return &table[i];
  }
  return NULL;
}

char **um_app_old_name_translate(struct um_app_old_name *old, int *argc, char **argv)
{
  int n = 0;
  char **out = calloc((size_t)*argc + 2, sizeof *out);
  if (out == NULL) return NULL;
  out[n++] = argv[0];
  out[n++] = old->verb;
  if (old->first[0] != '\0') out[n++] = old->first;
  for (int i = 2; i < *argc; i++) out[n++] = argv[i];
  *argc = n;
  fprintf(stderr, "umbra %s is now umbra %s%s%s; the old name works until version " UNTIL "\n",
          old->name, old->verb, old->first[0] != '\0' ? " " : "", old->first);
  return out;
}
