/* What the files and pictures of a diagnosis share. Private to diagnosis/report/. */
#ifndef UMBRA_DIAGNOSIS_REPORT_REPORT_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_REPORT_IMPL_H

#include "diagnosis/report/channels.h"
#include "diagnosis/report/report.h"

/* A model value in the unit of the channel's quantity, from the linear one; NaN for a magnitude of
 * no light. */
double um_diagnosis_report_in_unit(enum um_compare_quantity quantity, double linear);
/* Linear estimate of column k and its sigma in the parameter's unit. */
void um_diagnosis_report_estimate(const struct um_sensitivity_candidate *candidate,
                                  const struct um_inference_score *score, size_t k, double *value,
                                  double *sigma);
/* improved.c: improved/scenario.yaml into the folder at `path`. */
enum um_status um_diagnosis_report_improved_write(struct um_context *context,
                                                  const struct um_diagnosis *diagnosis,
                                                  const char *command, const char *version,
                                                  const char *path);

#endif
