/* The shape of missing heat in words. */
#include <stdio.h>
#include <string.h>

#include "evidence/missing_heat/heat.h"
#include "evidence/missing_heat/policy.h"

void um_missing_heat_text(const struct um_missing_heat *heat, char out[UM_MISSING_HEAT_TEXT])
{
  const struct um_thermal_course *c = &heat->course;
  size_t size = UM_MISSING_HEAT_TEXT;
  switch (c->shape) {
  case UM_HEAT_PULSE:
    snprintf(out, size, ", a pulse of %.4g W for %.4g +- %.2g s", heat->power, c->last,
             heat->last_sigma);
    break;
  case UM_HEAT_DECAY:
    snprintf(out, size, ", a decay from %.4g W with a time constant of %.4g +- %.2g s", heat->power,
             c->last, heat->last_sigma);
    break;
  case UM_HEAT_PERIODIC:
    snprintf(out, size, ", %.4g W for %.4g +- %.2g s in every %.4g +- %.2g s", heat->power, c->last,
             heat->last_sigma, c->period, heat->period_sigma);
    break;
  case UM_HEAT_STEP:
  case UM_HEAT_SHAPES:
    snprintf(out, size, ", a step to %.4g W that lasts to the end", heat->power);
    break;
  }
  for (int s = 0; s < UM_HEAT_SHAPES; s++) {
    size_t used = strlen(out);
    if (s == (int)c->shape || !(heat->behind[s] < UM_MISSING_HEAT_RIVAL)) continue;
    snprintf(out + used, size - used, "; or %s (BIC %+.1f)",
             s == UM_HEAT_STEP    ? "a step"
             : s == UM_HEAT_PULSE ? "a pulse"
             : s == UM_HEAT_DECAY ? "a decay"
                                  : "on and off",
             heat->behind[s]);
  }
}
