/* A diagnosis as tables. */
#ifndef UMBRA_DIAGNOSIS_REPORT_TEXT_H
#define UMBRA_DIAGNOSIS_REPORT_TEXT_H

#include <stdio.h>

#include "evidence/diagnosis/diagnosis.h"

/* Everything that a person may ask of it, as text: channels before and after, steps with their
 * alternatives, what a sceptic asks, what is left, what to measure next. Errors of writing are the
 * stream's. UM_ERR_MEMORY. */
enum um_status um_diagnosis_report_write_text(struct um_context *context,
                                              const struct um_diagnosis *diagnosis, FILE *file);

/* Of a fit: pairs of values that cannot be told apart, and the draws of its posterior; of a
 * diagnosis nothing. */
void um_diagnosis_report_write_text_posterior(const struct um_diagnosis *diagnosis, FILE *file);

#endif
