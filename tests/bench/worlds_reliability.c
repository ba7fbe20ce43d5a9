/* Whether stated probabilities mean what they say: a reliability diagram as a table. */
#include <stdlib.h>
#include <string.h>

#include "tests/bench/worlds.h"

static const double edge[WORLDS_BINS + 1] = {0.0, 0.1, 0.3, 0.7, 0.9, 0.99, 1.0};

void worlds_reliability_add(const struct worlds_world *world, const struct worlds_answer *answer,
                            struct worlds_reliability *out)
{
  if (world->also[0] != '\0') return;
  for (const char *at = answer->stated; at != NULL && *at != '\0';) {
    char name[WORLDS_TEXT], value[64];
    if (sscanf(at, "%255s %63s", name, value) == 2) {
      double p = strtod(value, NULL);
      size_t bin = 0;
      while (bin + 1 < WORLDS_BINS && p >= edge[bin + 1]) bin++;
      out->count[bin]++;
      out->right[bin] += worlds_is_hidden(world, name);
      out->sum[bin] += p;
    }
    at = strstr(at, " + ");
    if (at != NULL) at += 3;
  }
}

void worlds_reliability_print(const struct worlds_reliability *r)
{
  bool any = false;
  for (size_t bin = 0; bin < WORLDS_BINS; bin++) {
    if (r->count[bin] == 0) continue;
    if (!any) printf("\n| stated | statements | mean stated | true |\n|---|---|---|---|\n");
    any = true;
    printf("| %g to %g | %zu | %.3f | %.3f |\n", edge[bin], edge[bin + 1], r->count[bin],
           r->sum[bin] / (double)r->count[bin], (double)r->right[bin] / (double)r->count[bin]);
  }
}
