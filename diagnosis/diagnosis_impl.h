/* A diagnosis in the making. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_DIAGNOSIS_IMPL_H
#define UMBRA_DIAGNOSIS_DIAGNOSIS_IMPL_H

#include "diagnosis/diagnosis.h"

/* No steps any more. */
void um_diagnosis_steps_clear(struct um_context *context, struct um_diagnosis *d);
/* No effects and nuisances at the end any more. */
void um_diagnosis_end_clear(struct um_context *context, struct um_diagnosis *d);
/* No next measurement any more. */
void um_diagnosis_next_clear(struct um_context *context, struct um_diagnosis *d);

#endif
