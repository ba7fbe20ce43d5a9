/* What no effect of the catalogue explains, in words: light, and which half is wrong. */
#include <math.h>
#include <stdio.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/steps_impl.h"

void um_diagnosis_light_text(const struct um_diagnosis *d, char out[UM_DIAGNOSIS_LIGHT_TEXT])
{
  char light[UM_MISSING_LIGHT_TEXT];
  double explained = d->light.chi2_before - d->light.chi2_after;
  out[0] = '\0';
  if (!d->light.any || !(d->light.worth > UM_DIAGNOSIS_EVIDENCE)) return;
  if (d->unexplained != NULL && d->unexplained->found && !d->light.found) return; /* heat does */
  um_missing_light_text(&d->light, light);
  if (d->light.found)
    snprintf(out, UM_DIAGNOSIS_LIGHT_TEXT, " A correction of light explains it: %s.", light);
  else
    snprintf(out, UM_DIAGNOSIS_LIGHT_TEXT,
             " A correction of light explains %.0f %% of chi-square: %s.",
             100.0 * explained / d->light.chi2_before, light);
}

void um_diagnosis_half_text(const struct um_diagnosis *d, char out[UM_DIAGNOSIS_HALF_TEXT])
{
  size_t best = 0;
  out[0] = '\0';
  if (isnan(d->half[0])) return;
  for (size_t h = 1; h < UM_HALVES; h++)
    if (d->half[h] > d->half[best]) best = h;
  snprintf(out, UM_DIAGNOSIS_HALF_TEXT, " What is wrong is most likely %s (probability %.2g).",
           um_effects_half_text((enum um_effects_half)best), d->half[best]);
}
