/* What to measure next, in words. */
#ifndef UMBRA_DIAGNOSIS_REPORT_NEXT_TEXT_H
#define UMBRA_DIAGNOSIS_REPORT_NEXT_TEXT_H

#include "evidence/diagnosis/diagnosis.h"

#define UM_DIAGNOSIS_NEXT_TEXT 512 /* [bytes] */

/* What would tell, the same words for alternatives that the same tells. */
void um_diagnosis_report_next_text(const struct um_diagnosis_next *next,
                                   char out[UM_DIAGNOSIS_NEXT_TEXT]);
/* Does the same tell both from the winner of the same step? */
bool um_diagnosis_report_next_same(const struct um_diagnosis_next *a,
                                   const struct um_diagnosis_next *b);

#endif
