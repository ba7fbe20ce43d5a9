/* What an effect reaches, from its hooks: the one place that says what must be computed again when
 * its values change. */
#include "effects/effects.h"

uint32_t um_effects_reach(const struct um_effect *effect)
{
  const struct um_effect_hooks *h = &effect->hooks;
  uint32_t reach = 0;
  if (h->geometry != NULL) reach |= UM_REACH_GEOMETRY | UM_REACH_THERMAL | UM_REACH_OPTICS;
  if (h->time != NULL || h->exposure != NULL || h->along_track != NULL || h->law != NULL ||
      h->attitude != NULL)
    reach |= UM_REACH_GEOMETRY | UM_REACH_THERMAL | UM_REACH_OPTICS;
  if (h->environment != NULL || effect->switch_off != NULL)
    reach |= UM_REACH_LIGHT | UM_REACH_THERMAL | UM_REACH_OPTICS;
  if (h->material != NULL || h->creases != NULL || h->flatness != NULL)
    reach |= UM_REACH_THERMAL | UM_REACH_OPTICS;
  if (h->sky != NULL) reach |= UM_REACH_OPTICS;
  if (h->part != NULL || h->group != NULL || h->contact != NULL) reach |= UM_REACH_THERMAL;
  if (h->observation != NULL) reach |= UM_REACH_OBSERVATION;
  return reach;
}

/* What it reaches but for light that has left the satellite. */
static uint32_t reach_before(const struct um_effect *effect)
{
  struct um_effect rest = *effect;
  rest.hooks.sky = NULL;
  rest.hooks.observation = NULL;
  return um_effects_reach(&rest);
}

bool um_effects_act_behind(const struct um_effect *effect) { return reach_before(effect) == 0; }

bool um_effects_light_alike(const struct um_effect *effect)
{
  return (reach_before(effect) & ~(uint32_t)UM_REACH_THERMAL) == 0;
}

bool um_effects_may_be_of_a_set(const struct um_effect *effect)
{
  static const struct um_effect_hooks none;
  struct um_effect_hooks rest = effect->hooks;
  rest.time = NULL;
  rest.exposure = NULL;
  rest.observation = NULL;
  return memcmp(&rest, &none, sizeof rest) == 0 && !effect->on_by_default;
}

const char *um_effects_set_of(const struct um_effect *effect, const char *target)
{
  const char *at = target != NULL ? strrchr(target, '@') : NULL;
  return at != NULL && um_effects_may_be_of_a_set(effect) ? at + 1 : NULL;
}

size_t um_effects_place_of(const struct um_effect *effect, const char *target)
{
  const char *set = um_effects_set_of(effect, target);
  if (set == NULL) return target != NULL ? strlen(target) : 0;
  size_t n = (size_t)(set - target) - 1;
  bool all = n == strlen(UM_EFFECTS_ALL) && strncmp(target, UM_EFFECTS_ALL, n) == 0;
  return all ? 0 : n;
}
