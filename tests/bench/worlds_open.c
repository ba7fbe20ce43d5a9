/* Open set: what is hidden, and what looks like it, is in no catalogue. */
#include <string.h>

#include "effects/effects.h"
#include "effects/half.h"
#include "tests/bench/worlds.h"

#define PULSE "pulse" /* heat of its own, of no catalogue anyway */

/* The effect of one of several names that are parted by '|': what stands before its target. */
static const char *next_effect(const char *names, char effect[WORLDS_TEXT])
{
  size_t n = strcspn(names, "|"), length = strcspn(names, ":*|");
  snprintf(effect, WORLDS_TEXT, "%.*s", (int)length, names);
  return names + n + (names[n] == '|');
}

static void add(const char *names, char text[WORLDS_LEFT_OUT][WORLDS_TEXT], size_t *count)
{
  while (*names != '\0') {
    char effect[WORLDS_TEXT];
    size_t i = 0;
    names = next_effect(names, effect);
    while (i < *count && strcmp(text[i], effect) != 0) i++;
    if (i < *count || *count == WORLDS_LEFT_OUT || um_effects_find(effect) == NULL) continue;
    strcpy(text[(*count)++], effect);
  }
}

void worlds_left_out(const struct worlds_world *world, char text[WORLDS_LEFT_OUT][WORLDS_TEXT],
                     size_t *count)
{
  *count = 0;
  for (size_t i = 0; i < world->nhidden; i++) add(world->hidden[i].names, text, count);
  add(world->also, text, count);
}

bool worlds_half_is_right(const struct worlds_world *world, const char *half)
{
  for (size_t i = 0; i < world->nhidden; i++) {
    const char *names = world->hidden[i].names;
    if (strncmp(names, PULSE ":", strlen(PULSE ":")) == 0)
      return strcmp(half, um_effects_half_name(UM_HALF_HEAT)) == 0;
    while (*names != '\0') {
      char effect[WORLDS_TEXT];
      names = next_effect(names, effect);
      const struct um_effect *found = um_effects_find(effect);
      if (found != NULL && strcmp(half, um_effects_half_name(um_effects_half_of(found))) == 0)
        return true;
    }
  }
  return false;
}
