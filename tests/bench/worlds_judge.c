/* How good an answer is. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bench/worlds.h"

#define SIGMAS 3.0

static bool one_matches(const char *pattern, size_t n, const char *name)
{
  if (n > 0 && pattern[n - 1] == '*') return strncmp(pattern, name, n - 1) == 0;
  return strlen(name) == n && strncmp(pattern, name, n) == 0;
}

bool worlds_names_match(const char *names, const char *name)
{
  for (const char *at = names; *at != '\0';) {
    size_t n = strcspn(at, "|");
    if (n > 0 && one_matches(at, n, name)) return true;
    at += n + (at[n] == '|');
  }
  return false;
}

/* Size of the smallest group (between blanks, parted by '+') that holds one of the names; 0: none.
 */
static size_t group_with(const char *groups, const char *names)
{
  char copy[WORLDS_LONG], *outer = NULL;
  size_t smallest = 0;
  snprintf(copy, sizeof copy, "%s", groups);
  for (char *g = strtok_r(copy, " ", &outer); g != NULL; g = strtok_r(NULL, " ", &outer)) {
    char *inner = NULL;
    size_t size = 0;
    bool holds = false;
    for (char *w = strtok_r(g, "+", &inner); w != NULL; w = strtok_r(NULL, "+", &inner), size++)
      holds = holds || worlds_names_match(names, w);
    if (holds && (smallest == 0 || size < smallest)) smallest = size;
  }
  return smallest;
}

bool worlds_is_hidden(const struct worlds_world *world, const char *name)
{
  for (size_t i = 0; i < world->nhidden; i++)
    if (worlds_names_match(world->hidden[i].names, name)) return true;
  return false;
}

static bool has_false(const struct worlds_world *world, const char *certain)
{
  char copy[WORLDS_LONG], *rest = NULL;
  snprintf(copy, sizeof copy, "%s", certain);
  for (char *w = strtok_r(copy, " ", &rest); w != NULL; w = strtok_r(NULL, " ", &rest))
    if (!worlds_is_hidden(world, w)) return true;
  return false;
}

/* A group none of whose effects is hidden. */
static bool has_false_group(const struct worlds_world *world, const char *groups)
{
  char copy[WORLDS_LONG], *outer = NULL;
  snprintf(copy, sizeof copy, "%s", groups);
  for (char *g = strtok_r(copy, " ", &outer); g != NULL; g = strtok_r(NULL, " ", &outer)) {
    char *inner = NULL;
    bool there = false;
    for (char *w = strtok_r(g, "+", &inner); w != NULL; w = strtok_r(NULL, "+", &inner))
      there = there || worlds_is_hidden(world, w);
    if (!there) return true;
  }
  return false;
}

static bool is_unexplained(const struct worlds_answer *answer)
{
  return strcmp(answer->verdict, "unexplained") == 0 && answer->certain[0] == '\0';
}

double worlds_isolation(const struct worlds_world *world, const struct worlds_answer *answer)
{
  double sum = 0.0;
  size_t n = 0;
  if (world->nhidden == 0) return NAN;
  if (isfinite(answer->probability)) return answer->probability;
  if (world->good == WORLDS_UNEXPLAINED) return is_unexplained(answer) ? 1.0 : 0.0;
  for (size_t i = 0; i < world->nhidden; i++) {
    const struct worlds_hidden *h = &world->hidden[i];
    if (h->optional) continue;
    size_t size =
        group_with(answer->certain, h->names) > 0 ? 1 : group_with(answer->groups, h->names);
    sum += size > 0 ? 1.0 / (double)size : 0.0;
    n++;
  }
  return n > 0 ? sum / (double)n : (double)NAN;
}

/* Each hidden effect is named, or a group holds it or what looks like it. */
static bool all_are_named(const struct worlds_world *world, const struct worlds_answer *answer)
{
  for (size_t i = 0; i < world->nhidden; i++) {
    const char *names = world->hidden[i].names;
    if (world->hidden[i].optional) continue;
    if (group_with(answer->certain, names) == 0 && group_with(answer->groups, names) == 0 &&
        group_with(answer->groups, world->also) == 0)
      return false;
  }
  return true;
}

static bool is_right(const struct worlds_world *world, const struct worlds_answer *answer,
                     const struct worlds_judgement *j)
{
  switch (world->good) {
  case WORLDS_FOUND:
  case WORLDS_GROUP:
    return !j->false_certain && all_are_named(world, answer);
  case WORLDS_COMPLETE:
    return strcmp(answer->verdict, "complete") == 0;
  case WORLDS_NOT_ALL:
    return !j->false_certain &&
           (strcmp(answer->verdict, "unexplained") == 0 ||
            strcmp(answer->verdict, "not_identifiable") == 0 || all_are_named(world, answer));
  case WORLDS_NOBODY:
    return !j->accused && strcmp(answer->verdict, "error") != 0;
  default:
    return is_unexplained(answer) && all_are_named(world, answer);
  }
}

/* Values of hidden effects that are stated. */
static void judge_values(const struct worlds_world *world, const char *values,
                         struct worlds_judgement *out)
{
  for (const char *at = values; at != NULL && *at != '\0';) {
    char name[WORLDS_TEXT], parameter[WORLDS_TEXT], value[64], sigma[64];
    if (sscanf(at, "%255s %255s %63s %63s", name, parameter, value, sigma) == 4)
      for (size_t i = 0; i < world->nhidden; i++)
        for (size_t k = 0; k < world->hidden[i].nvalue; k++) {
          const struct worlds_hidden *h = &world->hidden[i];
          if (!worlds_names_match(h->names, name) || strcmp(h->parameter[k], parameter) != 0)
            continue;
          double s = strtod(sigma, NULL);
          out->nvalue++;
          out->nwithin += fabs(strtod(value, NULL) - h->value[k]) <= SIGMAS * s;
        }
    at = strstr(at, " + ");
    if (at != NULL) at += 3;
  }
}

void worlds_judge(const struct worlds_world *world, const struct worlds_answer *answer,
                  struct worlds_judgement *out)
{
  bool failed = strcmp(answer->verdict, "error") == 0;
  *out = (struct worlds_judgement){.is_null = true};
  for (size_t i = 0; i < world->nhidden; i++)
    out->is_null = out->is_null && world->hidden[i].optional;
  out->detected = !failed && strcmp(answer->verdict, "complete") != 0;
  out->accused = has_false(world, answer->certain) || has_false_group(world, answer->groups);
  out->abstained = answer->certain[0] == '\0';
  out->false_certain = has_false(world, answer->certain);
  out->isolation = worlds_isolation(world, answer);
  out->right = !failed && is_right(world, answer, out);
  judge_values(world, answer->values, out);
}
