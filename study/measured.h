/* Which points of a study fit measurements, and what that says of the parameters. */
#ifndef UMBRA_STUDY_MEASURED_H
#define UMBRA_STUDY_MEASURED_H

#include <stdio.h>

#include "base/core/file.h"
#include "study/statistics.h"

struct um_study_measured {
  size_t used, left_out; /* rows of the file */
  double *chi2;          /* [npoint] over all channels; NaN of a point that failed */
  double *weight;        /* [npoint] exp(-chi2 / 2), their sum 1 */
  double effective;      /* how many equal points they are worth */
  size_t best;           /* the point with the least chi-square */
};

/* Hold every point's curves against a measurement file (evidence/measurements/measurements.h),
 * between the study's instants linearly in flux: chi-square by um_compare_metrics_compute, half the
 * study's stated error as the model's own sigma. The points being drawn from the prior, weights
 * exp(-chi2/2) make them the posterior (importance sampling). The result gains the quantities
 * "rms:CURVE" and "chi2_reduced:CURVE" of each channel. Rows flagged, without sigma, outside the
 * study's times or where nothing is seen are left out. UM_ERR_IO, UM_ERR_INPUT: the file, a channel
 * that the study has no curve of, no row left, a design that is no sample of the parameters (grids
 * of levels are; one at a time and Morris are not). The caller destroys. */
enum um_status um_study_measured_create(struct um_context *context, struct um_study_result *result,
                                        const char *path, struct um_study_measured **out);
/* Accepts NULL, sets NULL. */
void um_study_measured_destroy(struct um_context *context, struct um_study_measured **measured);

/* measured.csv (chi-square and weight of every point) and parameters.csv (each parameter before and
 * after the measurements). UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_study_measured_write(struct um_context *context,
                                       const struct um_study_result *result,
                                       const struct um_study_measured *measured,
                                       struct um_core_folder *folder);
/* The same for a person. */
enum um_status um_study_measured_print(struct um_context *context,
                                       const struct um_study_result *result,
                                       const struct um_study_measured *measured, FILE *file);

#endif
