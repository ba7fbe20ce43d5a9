/* What the files and pictures of a diagnosis share. Private to diagnosis/. */
#ifndef UMBRA_DIAGNOSIS_REPORT_IMPL_H
#define UMBRA_DIAGNOSIS_REPORT_IMPL_H

#include "diagnosis/diagnose.h"

/* Channel c of the measurements. */
const struct um_compare_channel *um_diagnosis_channel(const struct um_diagnosis *diagnosis,
                                                      size_t c);
/* Rows in use of channel c in order of time, as indices into the rows of the forward; *count may be
 * 0. The caller frees *out. */
enum um_status um_diagnosis_channel_rows(struct um_context *context,
                                         const struct um_diagnosis *diagnosis, size_t c,
                                         size_t **out, size_t *count);
/* Metrics of channel c with these model values [nrow], linear unit; dof: of all rows together, each
 * channel takes its share. count 0 and NaN where no row of it is in use. */
enum um_status um_diagnosis_channel_metrics(struct um_context *context,
                                            const struct um_diagnosis *diagnosis, size_t c,
                                            const double *value, double dof,
                                            struct um_compare_metrics *out);
/* A model value in the unit of the channel's quantity, from the linear one; NaN for a magnitude of
 * no light. */
double um_diagnosis_in_unit(enum um_compare_quantity quantity, double linear);
/* The candidate that a rival stands for. */
const struct um_diagnosis_candidate *
um_diagnosis_candidate_of(const struct um_diagnosis *diagnosis,
                          const struct um_diagnosis_rival *rival);
/* Linear estimate of column k and its sigma in the parameter's unit. */
void um_diagnosis_estimate(const struct um_diagnosis_candidate *candidate,
                           const struct um_diagnosis_score *score, size_t k, double *value,
                           double *sigma);
/* The last step that stayed; NULL: none. */
const struct um_diagnosis_step *um_diagnosis_last_step(const struct um_diagnosis *diagnosis);

/* improved.c: improved/scenario.yaml into the folder at `path`. */
enum um_status um_diagnosis_improved_write(struct um_context *context,
                                           const struct um_diagnosis *diagnosis,
                                           const char *command, const char *version,
                                           const char *path);

#endif
