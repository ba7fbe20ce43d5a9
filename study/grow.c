/* The surrogate of a study grows: what it wants are points of the study. */
#include <math.h>
#include <string.h>

#include "base/uncertainty/surrogate.h"
#include "study/stand_in_impl.h"

/* Is this the next point of the design? Then its parameters are that point's to the bit. */
static bool is_next(const struct stand_in *s, const double *place)
{
  size_t d = s->study->nbinding;
  if (s->taken == s->r->npoint) return false;
  for (size_t k = 0; k < d; k++)
    if (place[k] != s->place[s->taken * d + k]) return false;
  return true;
}

static void find_parameters(struct stand_in *s, const double *place, size_t n, double *parameter)
{
  size_t d = s->study->nbinding;
  for (size_t i = 0; i < n; i++) {
    double *to = parameter + i * d;
    if (is_next(s, place + i * d)) {
      memcpy(to, s->parameter + s->taken++ * d, d * sizeof *to);
      continue;
    }
    for (size_t k = 0; k < d; k++)
      to[k] = um_uncertainty_distribution_at_place(&s->study->binding[k].distribution,
                                                   place[i * d + k]);
  }
}

/* Points that the surrogate wants. Nothing is seen where the scenario as it stands shows nothing:
 * there the values are 0. A point that failed, or sees something else, is all NaN. */
static enum um_status evaluate(struct um_context *context, void *user, const double *place,
                               size_t n, double *value)
{
  enum um_status status;
  struct stand_in *s = user;
  const struct um_study *study = s->study;
  size_t d = study->nbinding, nvalue = study->nvalue;
  double *parameter = NULL;
  char **reason = NULL;
  UM_CHECK(um_core_allocate(context, n * d, sizeof *parameter, &parameter));
  UM_CHECK(um_core_allocate(context, n, sizeof *reason, &reason));
  find_parameters(s, place, n, parameter);
  UM_CHECK(um_study_solve(context, study, s->batch, parameter, n, value, reason));
  s->solved += n;
  for (size_t i = 0; i < n; i++) {
    double *v = value + i * nvalue;
    bool whole = reason[i] == NULL;
    for (size_t k = 0; k < nvalue; k++) {
      whole = whole && isnan(v[k]) == isnan(study->nominal[k]);
      if (isnan(study->nominal[k])) v[k] = 0.0;
    }
    for (size_t k = 0; k < nvalue && !whole; k++) v[k] = NAN;
    if (reason[i] != NULL)
      um_core_log(context, UM_LOG_WARNING, "a point of the surrogate failed: %s", reason[i]);
    um_core_free(context, reason[i]);
  }
done:
  UM_FREE(context, parameter, (void *)reason);
  return status;
}

double um_study_left(const struct um_study_result *r, size_t q)
{
  return r->quantity[q].asked - fmin(r->error[q], UM_STUDY_SHARE_SURROGATE * r->quantity[q].asked);
}

enum um_status um_study_grow(struct um_context *context, struct stand_in *s)
{
  enum um_status status;
  struct um_study_result *r = s->r;
  const struct um_study_file *file = s->study->file;
  struct um_uncertainty_group *group = NULL;
  UM_CHECK(um_core_allocate(context, r->nquantity, sizeof *group, &group));
  for (size_t q = 0; q < r->nquantity; q++) {
    bool relative = s->study->output[q].kind == UM_STUDY_IRRADIANCE;
    double left = um_study_left(r, q);
    group[q] = (struct um_uncertainty_group){.name = r->quantity[q].name,
                                             .first = r->quantity[q].first,
                                             .count = r->quantity[q].count,
                                             .absolute = relative ? 0.0 : left,
                                             .relative = relative ? left : 0.0,
                                             .floor = UM_STUDY_FLOOR};
  }
  const struct um_uncertainty_surrogate_request request = {.d = s->study->nbinding,
                                                           .nvalue = s->study->nvalue,
                                                           .ngroup = r->nquantity,
                                                           .group = group,
                                                           .evaluate = evaluate,
                                                           .user = s,
                                                           .held_out = (size_t)file->held_out,
                                                           .evaluations_max =
                                                               (size_t)file->evaluations,
                                                           .asked_at = s->place,
                                                           .nasked = r->npoint};
  UM_CHECK(um_uncertainty_surrogate_create(context, &request, &r->surrogate));
done:
  um_core_free(context, group);
  return status;
}
