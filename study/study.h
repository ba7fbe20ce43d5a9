/* A parameter study: many points of one scenario, with what they have in common computed once. */
#ifndef UMBRA_STUDY_STUDY_H
#define UMBRA_STUDY_STUDY_H

#include <stdio.h>

#include "base/batch/task.h"
#include "model/build/model.h"
#include "study/result.h"

struct um_study;

/* How a study is run. Texts are borrowed while the study lives. */
struct um_study_run_options {
  struct um_model_options model; /* of the command line: --set, --with, --without */
  const char *version;           /* of the program; part of what points are of (identity.h) */
  const char *measured;          /* measurements in place of the file's, or NULL */
  /* folder of the records, resume, workers, share; the rest is filled in */
  struct um_batch_task batch;
};

/* Read study.yaml and its scenario; trace its geometry, solve its heat. Every parameter is tried at
 * both ends of its range; measurements are read once, to know that they can be. UM_ERR_INPUT with
 * file, line and key: what is wrong there, a parameter that changes nothing; errors of
 * um_model_create, _precompute and _run. Progress is reported. The caller destroys. */
enum um_status um_study_create(struct um_context *context, const char *path,
                               const struct um_study_run_options *options, struct um_study **out);
/* Accepts NULL, sets NULL. */
void um_study_destroy(struct um_context *context, struct um_study **study);
/* Path of the measurements that points are held against; NULL: none. */
const char *um_study_measurements(const struct um_study *study);

/* What is known before it runs, as text for people or as JSON: how many points, what each parameter
 * wants computed anew, how long and how much disk. One point is computed for that. */
enum um_status um_study_print_check(struct um_context *context, struct um_study *study, bool json,
                                    FILE *file);

/* All points, once. *out NULL: this process served another (um_batch_serve), or had a share of a
 * job array, which writes no results. A surrogate that is not accurate enough at its limit of
 * points ends with a result that says so (study/shortfall.h). UM_ERR_REFUSED: one of its points
 * failed in a share of a job array. Errors of um_batch_run. The caller destroys the result before
 * the study. */
enum um_status um_study_run(struct um_context *context, struct um_study *study,
                            struct um_study_result **out);

/* Points of the last um_study_run that are neither computed nor refused: a warning has named them,
 * and records are to stay. */
size_t um_study_lost(const struct um_study *study);

/* study.nc: netCDF-4 with coordinates (docs/files.md). points.csv: a row for every point, with its
 * parameters, the extremes of its curves, and metrics against measurements. UM_ERR_IO,
 * UM_ERR_MEMORY. */
enum um_status um_study_write_netcdf(struct um_context *context,
                                     const struct um_study_result *result, FILE *file);
void um_study_write_points(const struct um_study_result *result, FILE *file);

#endif
