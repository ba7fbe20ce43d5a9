/* Candidates that were not fitted. Private to evidence/diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_MISSED_IMPL_H
#define UMBRA_DIAGNOSIS_MISSED_IMPL_H

#include "evidence/diagnosis/diagnosis.h"
#include "evidence/diagnosis/work_impl.h"

/* Fill d->missed, after all fits are made and the baseline is ranked. */
enum um_status um_diagnosis_missed_find(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        struct um_diagnosis *d);

#endif
