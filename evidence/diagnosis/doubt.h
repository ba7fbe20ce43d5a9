/* Why an effect that no other comes near is not certain all the same. */
#ifndef UMBRA_DIAGNOSIS_DOUBT_H
#define UMBRA_DIAGNOSIS_DOUBT_H

#include "evidence/diagnosis/diagnosis.h"

/* The reason, in words that continue a sentence; NULL: there is none. d: with its steps and
 * d->sceptic. Static. */
const char *um_diagnosis_doubt_of(const struct um_diagnosis *d,
                                  const struct um_diagnosis_step *step);

#endif
