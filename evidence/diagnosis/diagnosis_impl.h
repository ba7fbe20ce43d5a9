/* Parts of a diagnosis, cleared before they are made anew. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_DIAGNOSIS_IMPL_H
#define UMBRA_DIAGNOSIS_DIAGNOSIS_IMPL_H

#include "evidence/diagnosis/diagnosis.h"

/* Accepts NULL, sets NULL. */
void um_diagnosis_posterior_destroy(struct um_context *context,
                                    struct um_diagnosis_posterior **posterior);
/* Free the steps. */
void um_diagnosis_steps_clear(struct um_context *context, struct um_diagnosis *d);
/* Free the final effects and nuisances. */
void um_diagnosis_end_clear(struct um_context *context, struct um_diagnosis *d);
/* Free the next measurements. */
void um_diagnosis_next_clear(struct um_context *context, struct um_diagnosis *d);

#endif
