/* Which half of the model is wrong. Explanations compete by how much better they are than the
 * scenario as it is,
 *
 *   P(half) ~ exp(g / 2),   g = the largest (BIC of nothing - BIC) / s of its explanations,
 *
 * s the reduced chi-square that is left of what no noise was estimated for, at least 1; each half
 * has the same prior. Explanations are each candidate alone (by its fit, else by the linear model),
 * all effects that the search ended with, missing heat and missing light. One of several effects
 * counts for the half of each in equal shares. */
#include <math.h>

#include "effects/half.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* BIC of a candidate alone: of its fit in the first step, else by the linear model. INFINITY: it is
 * no explanation. */
static double alone(const struct um_diagnosis *d, const struct um_diagnosis_state *bare,
                    const struct um_diagnosis_alternative *score)
{
  const struct um_diagnosis_step *first = d->nstep > 0 ? &d->step[0] : NULL;
  for (size_t i = 0; first != NULL && i < first->nalternative; i++)
    if (first->alternative[i].candidate == score->candidate && first->alternative[i].fitted)
      return first->alternative[i].bic;
  if (score->score.absorbed || score->score.p >= 0.5) return INFINITY;
  return bare->fit->bic - score->score.statistic +
         score->score.dof * log((double)bare->fit->nobservation);
}

/* The half whose error a correction of light would be, by its coordinate. */
static enum um_effects_half half_of_light(enum um_missing_light_kind kind,
                                          enum um_effect_coordinate coordinate)
{
  if (coordinate == UM_COORDINATE_AIRMASS || coordinate == UM_COORDINATE_ELEVATION ||
      coordinate == UM_COORDINATE_AZIMUTH)
    return UM_HALF_AIR;
  if (coordinate == UM_COORDINATE_SUNLIT || coordinate == UM_COORDINATE_NADIR_SUN)
    return UM_HALF_EARTH;
  if (kind == UM_LIGHT_IRRADIANCE || coordinate == UM_COORDINATE_TIME) return UM_HALF_INSTRUMENT;
  return UM_HALF_SURFACE;
}

double um_diagnosis_gain(const struct um_diagnosis *d, const struct um_diagnosis_state *bare,
                         double bic)
{
  double scale = 1.0, n = (double)bare->fit->nobservation;
  if (!d->weighed && d->light.any) scale = fmax(1.0, fmin(bic, d->light.chi2_after) / n);
  return (bare->fit->bic - bic) / scale;
}

static double gain_of_heat(const struct um_missing_heat_unexplained *u, double n)
{
  double scale = fmax(1.0, u->chi2_after / n);
  return (u->chi2_before - u->chi2_after) / scale - (double)u->heat[0].nparameter * log(n);
}

static void put(double gain[UM_HALVES], enum um_effects_half half, double of)
{
  if (isfinite(of)) gain[half] = fmax(gain[half], of);
}

/* The best correction of light, and what could be in its place. */
static void put_light(double gain[UM_HALVES], const struct um_missing_light *l)
{
  if (!l->any) return;
  put(gain, half_of_light(l->kind, l->coordinate), l->worth);
  for (size_t i = 0; i < l->nalternative; i++)
    put(gain, half_of_light(l->alternative[i].kind, l->alternative[i].coordinate),
        l->worth - l->alternative[i].behind);
}

void um_diagnosis_halves_assign(const struct um_diagnosis_state *bare, struct um_diagnosis *d)
{
  double gain[UM_HALVES], together[UM_HALVES] = {0}, several = -INFINITY, most, sum = 0.0;
  for (size_t h = 0; h < UM_HALVES; h++) {
    gain[h] = -INFINITY;
    d->half[h] = NAN;
  }
  bool asked = d->heat_asked != NULL || d->light_asked.any;
  const struct um_missing_heat_unexplained *heat =
      d->unexplained != NULL ? d->unexplained : d->heat_asked;
  const struct um_missing_light *light = d->light.any ? &d->light : &d->light_asked;
  if (d->verdict == UM_VERDICT_COMPLETE && !asked) return;
  for (size_t i = 0; i < d->nranking; i++) {
    const struct um_effect *effect = d->candidates->candidate[d->ranking[i].candidate].effect;
    put(gain, um_effects_half_of(effect),
        um_diagnosis_gain(d, bare, alone(d, bare, &d->ranking[i])));
  }
  if (heat != NULL && heat->nheat > 0)
    put(gain, UM_HALF_HEAT, gain_of_heat(heat, (double)bare->fit->nobservation));
  put_light(gain, light);
  for (size_t i = 0; i < d->naddition; i++)
    together[um_effects_half_of(d->addition[i].effect)] += 1.0 / (double)d->naddition;
  if (d->naddition > 1) several = um_diagnosis_gain(d, bare, d->bic_after);
  most = several;
  for (size_t h = 0; h < UM_HALVES; h++) most = fmax(most, gain[h]);
  if (!isfinite(most) || (d->verdict == UM_VERDICT_COMPLETE && most <= 0.0)) return;
  for (size_t h = 0; h < UM_HALVES; h++) {
    d->half[h] = exp(0.5 * (gain[h] - most)) + together[h] * exp(0.5 * (several - most));
    sum += d->half[h];
  }
  for (size_t h = 0; h < UM_HALVES; h++) d->half[h] /= sum;
}
