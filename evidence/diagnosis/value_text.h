/* Values of effects as text: the parameter, and beside it the number of the scenario that it makes.
 */
#ifndef UMBRA_DIAGNOSIS_VALUE_TEXT_H
#define UMBRA_DIAGNOSIS_VALUE_TEXT_H

#include "evidence/sensitivity/candidate.h"
#include "evidence/sensitivity/forward.h"

/* "200 +- 2.4 instead of 237 W/m^2" and what it is of, "outgoing longwave radiation". */
struct um_diagnosis_whole {
  const char *what, *unit;
  double value, sigma; /* with the effect; sigma NaN where that of the parameter is */
  double instead_of;   /* as the scenario stands */
};
/* Of parameter p of an effect on a target at a value; false: the scenario states nothing of it. */
bool um_diagnosis_whole_find(const struct um_sensitivity_forward *forward,
                             const struct um_effect *effect, const char *target, size_t p,
                             double value, double sigma, struct um_diagnosis_whole *out);

#define UM_DIAGNOSIS_VALUES_MAX 512
/* "factor 0.844 +- 0.01 (outgoing longwave radiation 200 +- 2.4 instead of 237 W/m^2)" of all
 * parameters that are fitted or not at their null value; "" for a switch. */
void um_diagnosis_values_text(const struct um_sensitivity_forward *forward,
                              const struct um_effect *effect, const char *target,
                              const double *value, const double *sigma,
                              char out[UM_DIAGNOSIS_VALUES_MAX]);
/* "(200 +- 2.4 instead of 237 W/m^2)" with what it is of; "" where nothing is stated. */
void um_diagnosis_whole_text(const struct um_diagnosis_whole *whole, char out[160]);
/* The largest distance of an alternative's values from the scenario's, in prior widths. */
double um_diagnosis_prior_widths(const struct um_sensitivity_candidate *candidate,
                                 const double *value);

#endif
