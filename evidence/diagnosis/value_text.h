/* Values of effects as text: the parameter, and beside it the number of the scenario that it makes.
 */
#ifndef UMBRA_DIAGNOSIS_VALUE_TEXT_H
#define UMBRA_DIAGNOSIS_VALUE_TEXT_H

#include "evidence/sensitivity/candidate.h"
#include "evidence/sensitivity/forward.h"

/* "41.50 +- 0.70": both to the second digit of sigma; the value alone where sigma is not finite.
 * between: what stands between them, "+-". Does not fail. */
void um_diagnosis_value_text(double value, double sigma, const char *between, char out[80]);

/* "200.0 +- 2.4 instead of 237 W/m^2" and what it is of, "outgoing longwave radiation". */
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
/* "factor 0.844 +- 0.010, outgoing longwave radiation 200.0 +- 2.4 instead of 237 W/m^2" of all
 * parameters that are fitted or not at their null value; "" for a switch. Where the scenario states
 * the parameter itself: "power_W 40.0 +- 1.2 instead of 20 W". wholes false: what the parameters
 * make of it is left out. */
void um_diagnosis_values_text(const struct um_sensitivity_forward *forward,
                              const struct um_effect *effect, const char *target,
                              const double *value, const double *sigma, bool wholes,
                              char out[UM_DIAGNOSIS_VALUES_MAX]);
/* "outgoing longwave radiation 200.0 +- 2.4 instead of 237 W/m^2". */
void um_diagnosis_whole_text(const struct um_diagnosis_whole *whole, char out[160]);
/* The largest distance of an alternative's values from the scenario's, in prior widths. */
double um_diagnosis_prior_widths(const struct um_sensitivity_candidate *candidate,
                                 const double *value);

#endif
