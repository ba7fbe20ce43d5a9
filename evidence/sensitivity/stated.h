/* What a scenario states of the thing that an effect changes: the whole beside the change, and how
 * far a change may go before the whole is no longer physical. */
#ifndef UMBRA_SENSITIVITY_STATED_H
#define UMBRA_SENSITIVITY_STATED_H

#include "evidence/sensitivity/forward.h"

/* Of parameter p of an effect on a target, when its value is null_value in the scenario as it
 * stands. False where the scenario states nothing that is one number (a calibration, a clock). */
bool um_sensitivity_stated_find(const struct um_sensitivity_forward *forward,
                                const struct um_effect *effect, const char *target, size_t p,
                                double null_value, struct um_effect_stated *out);
/* The whole when the parameter has a value, within what is physical. */
double um_sensitivity_stated_whole(const struct um_effect_stated *stated, double value);
/* Range of the parameter: the effect's own, less where the whole would not be physical. It always
 * holds null_value. */
void um_sensitivity_stated_range(const struct um_sensitivity_forward *forward,
                                 const struct um_effect *effect, const char *target, size_t p,
                                 double null_value, double *minimum, double *maximum);
/* Whether an effect has nothing to do on a target, whatever its value: electricity of a side that
 * gives none and is too bright for cells. A few words why; NULL: it makes sense. */
const char *um_sensitivity_stated_refusal(const struct um_sensitivity_forward *forward,
                                          const struct um_effect *effect, const char *target);

#endif
