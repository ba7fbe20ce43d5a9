/* What a diagnosis says, channel by channel. */
#ifndef UMBRA_DIAGNOSIS_REPORT_CHANNELS_H
#define UMBRA_DIAGNOSIS_REPORT_CHANNELS_H

#include "evidence/comparison/metrics.h"
#include "evidence/diagnosis/diagnosis.h"

/* Channel c of the measurements. */
const struct um_compare_channel *um_diagnosis_report_channel(const struct um_diagnosis *diagnosis,
                                                             size_t c);
/* Observations in use of channel c in order of time, as indices into the observations of the
 * forward; *count may be 0. The caller frees *out. */
enum um_status um_diagnosis_report_channel_rows(struct um_context *context,
                                                const struct um_diagnosis *diagnosis, size_t c,
                                                size_t **out, size_t *count);
/* Metrics of channel c with these model values [nobservation], linear unit; dof: of all
 * observations together, each channel takes its share. count 0 and NaN where no row of it is in
 * use. */
enum um_status um_diagnosis_report_channel_metrics(struct um_context *context,
                                                   const struct um_diagnosis *diagnosis, size_t c,
                                                   const double *value, double dof,
                                                   struct um_compare_metrics *out);
/* The candidate that an alternative stands for. */
const struct um_sensitivity_candidate *
um_diagnosis_report_candidate_of(const struct um_diagnosis *diagnosis,
                                 const struct um_diagnosis_alternative *alternative);
/* Model values [nobservation] as of a step, linear unit: its own, or the final ones where nothing
 * came after it; NULL: not kept. */
const double *um_diagnosis_report_step_values(const struct um_diagnosis *diagnosis,
                                              const struct um_diagnosis_step *step);

/* A model value in the unit of the channel's quantity, from the linear one; NaN for a magnitude of
 * no light. */
double um_diagnosis_report_in_unit(enum um_compare_quantity quantity, double linear);
/* Linear estimate of column k and its sigma in the parameter's unit. */
void um_diagnosis_report_estimate(const struct um_sensitivity_candidate *candidate,
                                  const struct um_inference_score *score, size_t k, double *value,
                                  double *sigma);

#endif
