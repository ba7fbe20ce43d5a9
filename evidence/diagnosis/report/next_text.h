/* What to measure next, in words. */
#ifndef UMBRA_DIAGNOSIS_REPORT_NEXT_TEXT_H
#define UMBRA_DIAGNOSIS_REPORT_NEXT_TEXT_H

#include "evidence/diagnosis/diagnosis.h"

#define UM_DIAGNOSIS_NEXT_TEXT 512 /* [bytes] */

/* What would tell, the same words for alternatives that the same tells. */
void um_diagnosis_report_next_text(const struct um_diagnosis_next *next,
                                   char out[UM_DIAGNOSIS_NEXT_TEXT]);
/* What a pass to come would tell. */
void um_diagnosis_report_pass_text(const struct um_diagnosis_pass *pass,
                                   char out[UM_DIAGNOSIS_NEXT_TEXT]);
/* The one that tells most; NULL: there is none. */
const struct um_diagnosis_pass *um_diagnosis_report_best_pass(const struct um_diagnosis_next *next);
/* Does the same tell both from the winner of the same step? */
bool um_diagnosis_report_next_same(const struct um_diagnosis_next *a,
                                   const struct um_diagnosis_next *b);

#endif
