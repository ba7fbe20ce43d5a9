/* In which half of a model an effect stands: what is wrong where it is missing. */
#ifndef UMBRA_EFFECTS_HALF_H
#define UMBRA_EFFECTS_HALF_H

#include "effects/effect.h"

enum um_effects_half {
  UM_HALF_HEAT,       /* power, capacity, conduction, insulation */
  UM_HALF_SURFACE,    /* what surfaces take, return and emit */
  UM_HALF_GEOMETRY,   /* shapes, places, attitude */
  UM_HALF_EARTH,      /* Sun, Earth and its shadow, Moon */
  UM_HALF_AIR,        /* above the station */
  UM_HALF_INSTRUMENT, /* detector, calibration, clock */
  UM_HALVES
};

/* "heat", "surface", "geometry_attitude", "earth_shadow", "air", "instrument" */
const char *um_effects_half_name(enum um_effects_half half);
/* "geometry or attitude": as a sentence has it. */
const char *um_effects_half_text(enum um_effects_half half);

/* By the table of effects/half.c; of an effect that is not in it by the first of its hooks. Does
 * not fail. Test: tests/effects/registry.c has all that are built in. */
enum um_effects_half um_effects_half_of(const struct um_effect *effect);

#endif
