/* Points of a study's design. */
#include <limits.h>

#include "base/uncertainty/design.h"
#include "study/study_impl.h"

static enum um_status grid(struct um_context *context, const struct um_study *study, double **u,
                           size_t *n)
{
  size_t count[UM_STUDY_PARAMETERS_MAX];
  bool ends[UM_STUDY_PARAMETERS_MAX];
  for (size_t i = 0; i < study->nbinding; i++) {
    const struct um_study_file_parameter *p = study->binding[i].file;
    ends[i] = p->values.count == 0;
    count[i] = p->values.count;
    if (ends[i])
      count[i] = (size_t)(p->levels != INT_MIN ? p->levels : study->file->design->levels);
  }
  return um_uncertainty_grid(context, study->nbinding, count, ends, u, n);
}

static enum um_status one_at_a_time(struct um_context *context, const struct um_study *study,
                                    double **u, size_t *n)
{
  double centre[UM_STUDY_PARAMETERS_MAX];
  for (size_t i = 0; i < study->nbinding; i++) centre[i] = 0.5;
  return um_uncertainty_one_at_a_time(context, study->nbinding, (size_t)study->file->design->levels,
                                      centre, u, n);
}

static enum um_status design(struct um_context *context, const struct um_study *study, double **u,
                             size_t *n)
{
  const struct um_study_file_design *d = study->file->design;
  size_t points = (size_t)d->points;
  uint64_t seed = (uint64_t)d->seed;
  *n = (size_t)um_study_file_points(study->file);
  switch ((enum um_study_design)d->kind) {
  case UM_STUDY_GRID:
    return grid(context, study, u, n);
  case UM_STUDY_LIST:
    return um_uncertainty_paired(context, study->nbinding, *n, u);
  case UM_STUDY_LATIN_HYPERCUBE:
    return um_uncertainty_latin_hypercube(context, study->nbinding, points, seed, u);
  case UM_STUDY_ONE_AT_A_TIME:
    return one_at_a_time(context, study, u, n);
  case UM_STUDY_SALTELLI:
    return um_uncertainty_saltelli(context, study->nbinding, points, seed, u);
  case UM_STUDY_MORRIS:
    return um_uncertainty_morris_trajectories(context, study->nbinding, points, (size_t)d->levels,
                                              seed, u);
  case UM_STUDY_SOBOL:
    break;
  }
  return um_uncertainty_sobol_sequence(context, study->nbinding, points, seed, u);
}

size_t um_study_base(const struct um_study *study)
{
  int kind = study->file->design->kind;
  return kind == UM_STUDY_SALTELLI || kind == UM_STUDY_MORRIS ? (size_t)study->file->design->points
                                                              : 0;
}

enum um_status um_study_points(struct um_context *context, const struct um_study *study, double **u,
                               double **parameter, size_t *n)
{
  size_t d = study->nbinding;
  *u = *parameter = NULL;
  UM_TRY(design(context, study, u, n));
  UM_TRY(um_core_allocate(context, *n * d, sizeof **parameter, parameter));
  for (size_t i = 0; i < *n * d; i++)
    (*parameter)[i] =
        um_uncertainty_distribution_value(&study->binding[i % d].distribution, (*u)[i]);
  return UM_OK;
}
