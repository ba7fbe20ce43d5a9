/* In which half of a model an effect stands. Hooks say it of most; the table has those of which
 * they do not. */
#include "effects/half.h"

const char *um_effects_half_name(enum um_effects_half half)
{
  static const char *const name[] = {"heat",         "surface", "geometry_attitude",
                                     "earth_shadow", "air",     "instrument"};
  return name[half];
}

const char *um_effects_half_text(enum um_effects_half half)
{
  static const char *const text[] = {
      "heat",    "a surface",     "geometry or attitude", "the Earth, its shadow or the Sun",
      "the air", "the instrument"};
  return text[half];
}

/* What hooks do not say: whose environment or switch it is, whose reading. */
static const struct {
  const char *effect;
  enum um_effects_half half;
} table[] = {
    {"atmosphere", UM_HALF_AIR},
    {"free_molecular_heating", UM_HALF_HEAT},
    {"mutual_radiation", UM_HALF_HEAT},
    {"solar_multiple_reflection", UM_HALF_HEAT},
    {"specular_exchange", UM_HALF_HEAT},
    {"bulk_temperature", UM_HALF_HEAT},
    {"panel_extraction", UM_HALF_HEAT},
    {"multiple_scattering", UM_HALF_SURFACE},
    {"inter_reflection", UM_HALF_SURFACE},
    {"absorptance_angle", UM_HALF_SURFACE},
    {"emittance_temperature", UM_HALF_SURFACE},
    {"earthlight_lobe", UM_HALF_SURFACE},
    {"mli_creases", UM_HALF_SURFACE},
    {"extinction", UM_HALF_AIR},
    {"path_radiance", UM_HALF_AIR},
    {"twilight", UM_HALF_AIR},
    {"sky_background", UM_HALF_AIR},
};

enum um_effects_half um_effects_half_of(const struct um_effect *effect)
{
  const struct um_effect_hooks *h = &effect->hooks;
  for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
    if (strcmp(table[i].effect, effect->name) == 0) return table[i].half;
  if (h->environment != NULL || effect->switch_off != NULL) return UM_HALF_EARTH;
  if (h->geometry != NULL || h->law != NULL || h->attitude != NULL || h->along_track != NULL ||
      h->creases != NULL || h->flatness != NULL)
    return UM_HALF_GEOMETRY;
  if (h->material != NULL) return UM_HALF_SURFACE;
  if (h->part != NULL || h->group != NULL || h->contact != NULL) return UM_HALF_HEAT;
  return h->sky != NULL ? UM_HALF_AIR : UM_HALF_INSTRUMENT;
}
