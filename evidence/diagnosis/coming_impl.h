/* Passes to come, as what could be measured next. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_COMING_IMPL_H
#define UMBRA_DIAGNOSIS_COMING_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/sensitivity/forward.h"

struct um_diagnosis_coming {
  struct um_diagnosis_pass *pass; /* [npass] by rise, of all stations; what they tell is not set */
  size_t npass;
  struct um_model_instants instants; /* the first measurement, then steps of the passes */
  double *time, *exposure;           /* [instants.count] of them */
  size_t *station;                   /* [instants.count] of them */
  size_t *of;                        /* [instants.count] pass; SIZE_MAX: none */
};

/* Has the scenario passes? UM_ERR_INPUT: no station, or orbit.points. */
enum um_status um_diagnosis_coming_check(struct um_context *context,
                                         const struct um_sensitivity_forward *forward);
/* The next `wanted` passes over each station behind the last measurement, above
 * observer.minimum_elevation_deg, within UM_DIAGNOSIS_DAYS and what the orbit covers; a warning
 * where there are none. Errors of um_orbit_passes_find. Released by the caller, after a failure
 * too. */
enum um_status um_diagnosis_coming_create(struct um_context *context,
                                          const struct um_sensitivity_forward *forward,
                                          size_t wanted, struct um_diagnosis_coming *out);
void um_diagnosis_coming_release(struct um_context *context, struct um_diagnosis_coming *coming);
/* Fill next->pass by two runs at coming->instants. UM_ERR_MEMORY. */
enum um_status um_diagnosis_coming_tell(struct um_context *context,
                                        const struct um_sensitivity_forward *forward,
                                        const struct um_diagnosis_coming *coming,
                                        const struct um_sensitivity_forward_run run[2],
                                        struct um_diagnosis_next *next);

#endif
