/* What numbers of a study or a forecast may be. */
#ifndef UMBRA_STUDY_ACCEPTS_H
#define UMBRA_STUDY_ACCEPTS_H

#include <math.h>
#include <stdbool.h>

#include "model/build/model.h"

/* Do effects of the model change readings? Then light may be below 0. */
bool um_study_light_has_sign(const struct um_model *model);

/* Light [W/m^2], or NAN where nothing is seen. */
static inline bool um_study_is_light(double value, bool has_sign)
{
  return isnan(value) || (isfinite(value) && (has_sign || value >= 0.0));
}

/* [K] */
static inline bool um_study_is_temperature(double value) { return isfinite(value) && value > 0.0; }

/* No light is an infinite magnitude; an infinite light is none. */
static inline bool um_study_is_magnitude(double value) { return !(value == -(double)INFINITY); }

#endif
