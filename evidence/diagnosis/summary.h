/* The verdict in words, for a person: diagnosis->summary is all parts. */
#ifndef UMBRA_DIAGNOSIS_SUMMARY_H
#define UMBRA_DIAGNOSIS_SUMMARY_H

#include "evidence/diagnosis/diagnosis.h"

#define UM_DIAGNOSIS_SUMMARY_MAX 8192 /* [bytes] */

/* What is missing, in the words of the effects, each with name, values and how sure it is: the
 * largest `most` of them, and how many more there are. A verdict that abstains names only what is
 * certain, and groups as groups. Sentences with a full stop each. Does not fail. */
void um_diagnosis_say_effects(const struct um_diagnosis *d, size_t most,
                              char out[UM_DIAGNOSIS_SUMMARY_MAX]);
/* How what is left differs from noise of the stated sigma; "": it does not, or the first part says
 * it. Does not fail. */
void um_diagnosis_say_noise(const struct um_diagnosis *d, char out[UM_DIAGNOSIS_SUMMARY_MAX]);
/* What was asked for and not fitted, the first `most` with the reason, and how many more; where
 * only one is said and there are more, how many. "": nothing, or nobody said what to look for. Does
 * not fail. */
void um_diagnosis_say_missed(const struct um_diagnosis *d, size_t most,
                             char out[UM_DIAGNOSIS_SUMMARY_MAX]);

#endif
